#pragma once

#include <cstdint>

namespace remeshd {

/// SplitMix64 (Steele, Lea & Flood 2014): small, fast, and the same on every platform, which the
/// distributions of <random> are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }
  /// As if `next` had been called n times.
  void skip(std::uint64_t n) { state_ += n * 0x9E3779B97F4A7C15ULL; }
  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  /// Uniform in [lo, hi).
  double uniform(double lo, double hi) { return lo + (hi - lo) * uniform(); }
  /// Uniform in {0, ..., n - 1}.
  std::uint64_t below(std::uint64_t n) {
    return static_cast<std::uint64_t>(static_cast<double>(n) * uniform());
  }

 private:
  std::uint64_t state_;
};

}  // namespace remeshd
