#pragma once

#include <string>
#include <utility>

#include "engine/remesh/report.h"
#include "engine/remesh/stopwatch.h"

namespace remeshd {

/// A strategy under way, timed from its beginning.
class Trial {
 public:
  explicit Trial(std::string strategy) : strategy_(std::move(strategy)) {}

  /// What the report tells of it where it is given up now.
  [[nodiscard]] Attempt given_up(std::string reason) const {
    return {strategy_, std::move(reason), watch_.total()};
  }

 private:
  std::string strategy_;
  Stopwatch watch_;
};

}  // namespace remeshd
