#pragma once

#include <map>
#include <string>

#include "engine/base/vec.h"

namespace remeshd::campaign {

/// What the verifier holds against a mesh: for each check that failed, how often and the first case
/// in words.
class Findings {
 public:
  void add(const std::string& check, const std::string& what);
  void add(const std::string& check, const std::string& what, const Vec3& place);

  struct Entry {
    int count = 0;
    std::string first;
  };
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] bool has(const std::string& check) const { return entries_.contains(check); }
  [[nodiscard]] const std::map<std::string, Entry>& entries() const { return entries_; }

 private:
  std::map<std::string, Entry> entries_;
};

/// `(1, 2.5, -3)`.
std::string text_of(const Vec3& p);

}  // namespace remeshd::campaign
