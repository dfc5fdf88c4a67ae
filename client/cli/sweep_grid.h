#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace remeshd::cli {

/// A parameter of the model, or one of a feature (`hole.radius`), and the values that it takes.
struct SweptParameter {
  std::string name;
  std::vector<double> values;
};

/// `steps` values from one to another, both included, evenly; a single one is the first.
std::vector<double> evenly_spread(double from, double to, int steps);

/// Of `wall=6:10:5` (FROM:TO:STEPS) or `hole.radius=4,5,6`. Throws UsageError for anything else.
SweptParameter parse_swept(const std::string& text);

/// Number of combinations of all values. Throws UsageError where there are more than a million, or
/// where a parameter is named twice.
std::uint64_t count_combinations(const std::vector<SweptParameter>& swept);

/// The `step`-th combination, from 0: a value for each parameter. The last parameter runs fastest,
/// up and down in turn, so that only one differs from step to step, and by one place.
std::vector<double> combination(const std::vector<SweptParameter>& swept, std::uint64_t step);

}  // namespace remeshd::cli
