#include "server/store/quarantine.h"

#include "engine/base/error.h"
#include "proto/checksum.h"
#include "server/store/files.h"

namespace remeshd {
namespace fs = std::filesystem;

void Quarantine::take(const fs::path& path, std::string_view why) {
  const std::string name = path.parent_path().filename().string() + "-" + path.filename().string();
  try {
    make_folder(folder_);
    fs::path to = folder_ / name;
    for (int i = 2; fs::exists(to); ++i) to = folder_ / (name + "." + std::to_string(i));
    rename_file(path, to);
    notes_.push_back(path.filename().string() + " was moved to quarantine/" +
                     to.filename().string() + ": " + std::string(why));
  } catch (const Error& failure) {
    notes_.push_back(path.filename().string() + " stays where it is (" + failure.what() +
                     "): " + std::string(why));
  }
}

void Quarantine::keep(std::string_view name, std::string_view bytes, std::string_view why) {
  const std::string unique = std::string(name) + "-" + sha256_hex(bytes).substr(0, 12);
  try {
    make_folder(folder_);
    if (!fs::exists(folder_ / unique)) write_durably(folder_ / unique, bytes, scratch_);
    notes_.push_back("kept in quarantine/" + unique + ": " + std::string(why));
  } catch (const Error& failure) {
    notes_.push_back("could not be kept in the quarantine (" + std::string(failure.what()) +
                     "): " + std::string(why));
  }
}

}  // namespace remeshd
