#pragma once

#include <random>

#include "server/limits.h"

namespace remeshd {

/// Random jitter for retry delays, so that clients that are refused together do not come back
/// together. Not thread-safe.
class Jitter {
 public:
  /// `seconds`, changed at random by a share of up to `limits::kDelayJitter` either way.
  double of(double seconds) {
    return seconds * std::uniform_real_distribution<double>(1 - limits::kDelayJitter,
                                                            1 + limits::kDelayJitter)(random_);
  }

 private:
  std::minstd_rand random_{std::random_device()()};
};

}  // namespace remeshd
