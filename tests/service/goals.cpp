#include "tests/service/goals.h"

#include <cstdio>

namespace remeshd::test {
namespace {

std::string line_of(const std::string& what, double value, const std::string& unit) {
  char text[256];
  std::snprintf(text, sizeof text, "%-46s %10.3f %s", what.c_str(), value, unit.c_str());
  return text;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace

void Goals::tell(const std::string& what, double value, const std::string& unit) const {
  std::printf("%s\n", line_of(what, value, unit).c_str());
  std::fflush(stdout);
}

void Goals::judge(const std::string& figure, const std::string& goal, bool reached, bool counts) {
  std::printf("%s (goal %s)%s\n", figure.c_str(), goal.c_str(),
              reached  ? ""
              : counts ? " MISSED"
                       : " missed, which does not count here");
  std::fflush(stdout);
  if (!reached && counts) missed_ = true;
}

void Goals::must(const std::string& what, bool holds) {
  std::printf("%-46s %10s%s\n", what.c_str(), holds ? "yes" : "no", holds ? "" : " MISSED");
  std::fflush(stdout);
  if (!holds) missed_ = true;
}

void Goals::must_be_at_most(const std::string& what, double value, const std::string& unit,
                            double goal) {
  judge(line_of(what, value, unit), "at most " + number(goal), value <= goal, true);
}

void Goals::at_most(const std::string& what, double value, const std::string& unit, double goal) {
  judge(line_of(what, value, unit), "at most " + number(goal), value <= goal, timed_);
}

void Goals::at_least(const std::string& what, double value, const std::string& unit, double goal) {
  judge(line_of(what, value, unit), "at least " + number(goal), value >= goal, timed_);
}

}  // namespace remeshd::test
