#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/results.h"

namespace remeshd::bench {

enum class Outcome { NotMeasured, Missed, Met, StretchMet };

/// Something that is asked of the results: a number that has to be at most a limit.
struct Goal {
  std::string group;  ///< what kind of goal
  std::string where;  ///< case and nodes
  std::optional<double> measured;
  std::optional<double> limit;    ///< nothing where it hangs on what was not measured, or there is
                                  ///< a stretch goal alone
  std::optional<double> stretch;  ///< wished for
  enum class Unit { Ratio, Percent, Bytes } unit = Unit::Ratio;

  /// With a stretch goal alone, missing that is missing the goal.
  [[nodiscard]] Outcome outcome() const;
};

/// Every goal, measured or not.
std::vector<Goal> judge(const Results& results);

}  // namespace remeshd::bench
