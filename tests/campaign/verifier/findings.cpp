#include "tests/campaign/verifier/findings.h"

#include <array>
#include <cstdio>

namespace remeshd::campaign {

void Findings::add(const std::string& check, const std::string& what) {
  Entry& entry = entries_[check];
  if (entry.count++ == 0) entry.first = what;
}

void Findings::add(const std::string& check, const std::string& what, const Vec3& place) {
  add(check, what + " at " + text_of(place));
}

std::string text_of(const Vec3& p) {
  std::array<char, 96> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "(%.9g, %.9g, %.9g)", p.x, p.y, p.z);
  return buffer.data();
}

}  // namespace remeshd::campaign
