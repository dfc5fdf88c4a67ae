#include "tests/campaign/record.h"

#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace remeshd::campaign {
namespace {

using nlohmann::json;

/// Tells builds of this program apart.
std::uint64_t this_build() {
  std::ifstream program("/proc/self/exe", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(program), {}};
  return std::hash<std::string>{}(bytes);
}

}  // namespace

Record::Record(std::filesystem::path file) : file_(std::move(file)) {
  if (file_.empty()) return;
  build_ = this_build();
  std::ifstream in(file_);
  for (std::string line; std::getline(in, line);) {
    const json j = json::parse(line, nullptr, false);  // the last may not be whole
    if (j.is_discarded() || j.at("build").get<std::uint64_t>() != build_) continue;
    lines_[j.at("request").get<std::vector<std::string>>()] = line;
  }
}

std::optional<WorkedCase> Record::find(const CaseRequest& request) const {
  const auto line = lines_.find(request.arguments());
  if (line == lines_.end()) return {};
  return read_worked(json::parse(line->second).at("worked"));
}

void Record::add(const CaseRequest& request, const WorkedCase& worked) const {
  if (file_.empty()) return;
  std::ofstream out(file_, std::ios::app);
  out << json{{"build", build_}, {"request", request.arguments()}, {"worked", write_worked(worked)}}
             .dump()
      << std::endl;
  if (!out) throw std::runtime_error("cannot write " + file_.string());
}

}  // namespace remeshd::campaign
