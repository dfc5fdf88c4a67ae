#pragma once

#include <random>

#include "server/limits.h"

namespace remeshd {

/// Has clients that are refused together come back apart. Not locked.
class Jitter {
 public:
  /// s, with the share of it added or taken that chance says.
  double of(double seconds) {
    return seconds * std::uniform_real_distribution<double>(1 - limits::kDelayJitter,
                                                            1 + limits::kDelayJitter)(random_);
  }

 private:
  std::minstd_rand random_{std::random_device()()};
};

}  // namespace remeshd
