#include "tests/campaign/store.h"

#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace remeshd::campaign {

std::filesystem::path store_failure(const std::filesystem::path& folder, const WorkedCase& worked,
                                    const Outcome& outcome) {
  CampaignCase c = worked.campaign_case;
  if (c.steps.size() > outcome.step) c.steps.resize(outcome.step);
  c.note = outcome.failure() + ": " + outcome.message;
  std::string name = outcome.kind + "-" + outcome.reason.substr(0, outcome.reason.find(','));
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '-';
  if (!c.part.empty()) name += "-" + c.part;
  name += "-" + std::to_string(c.seed) + "-" + std::to_string(c.number) + "-" +
          std::to_string(outcome.step) + ".json";
  std::filesystem::create_directories(folder);
  write_case_file(folder / name, c);
  return folder / name;
}

void write_case_file(const std::filesystem::path& file, const CampaignCase& c) {
  std::ofstream out(file);
  out << write_case(c).dump(1) << "\n";
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

CampaignCase read_case_file(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot open " + file.string());
  return read_case(nlohmann::json::parse(in));
}

}  // namespace remeshd::campaign
