#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "tests/campaign/work.h"

namespace remeshd::campaign {

/// The cases of a campaign that are done, a line of JSON each, so that one that was stopped goes on
/// where it was. Lines of another build of this program are not looked at.
class Record {
 public:
  /// An empty path remembers nothing.
  explicit Record(std::filesystem::path file);

  [[nodiscard]] std::optional<WorkedCase> find(const CaseRequest& request) const;
  /// Throws std::runtime_error where the file cannot be written.
  void add(const CaseRequest& request, const WorkedCase& worked) const;

 private:
  std::filesystem::path file_;
  std::uint64_t build_ = 0;                                ///< of this program
  std::map<std::vector<std::string>, std::string> lines_;  ///< by arguments of the request
};

}  // namespace remeshd::campaign
