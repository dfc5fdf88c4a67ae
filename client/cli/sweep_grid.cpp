#include "client/cli/sweep_grid.h"

#include <charconv>
#include <cmath>
#include <set>
#include <string_view>

#include "client/cli/exit_code.h"

namespace remeshd::cli {
namespace {

constexpr std::uint64_t kMostSteps = 1'000'000;

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw UsageError("--set " + text + ": " + why +
                   "; wanted is NAME=FROM:TO:STEPS or NAME=VALUE,VALUE,...");
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(at);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

double finite_number(std::string_view part, const std::string& text) {
  double value = 0;
  const char* end = part.data() + part.size();
  const auto [stop, problem] = std::from_chars(part.data(), end, value);
  if (problem != std::errc() || stop != end || !std::isfinite(value))
    refuse(text, "`" + std::string(part) + "` is no finite number");
  return value;
}

int step_count(std::string_view part, const std::string& text) {
  int steps = 0;
  const char* end = part.data() + part.size();
  const auto [stop, problem] = std::from_chars(part.data(), end, steps);
  if (problem != std::errc() || stop != end || steps < 1 ||
      static_cast<std::uint64_t>(steps) > kMostSteps)
    refuse(text, "`" + std::string(part) + "` is no number of steps within 1..1000000");
  return steps;
}

}  // namespace

std::vector<double> evenly_spread(double from, double to, int steps) {
  std::vector<double> values;
  for (int k = 0; k + 1 < steps; ++k) values.push_back(from + (to - from) * k / (steps - 1));
  values.push_back(steps == 1 ? from : to);
  return values;
}

SweptParameter parse_swept(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) refuse(text, "it names no parameter");
  SweptParameter swept{.name = text.substr(0, equals), .values = {}};
  const std::string_view values = std::string_view(text).substr(equals + 1);
  const auto range = split(values, ':');
  if (range.size() == 1) {
    for (const std::string_view part : split(values, ','))
      swept.values.push_back(finite_number(part, text));
    return swept;
  }
  if (range.size() != 3) refuse(text, "a range has three parts");
  swept.values = evenly_spread(finite_number(range[0], text), finite_number(range[1], text),
                               step_count(range[2], text));
  return swept;
}

std::uint64_t count_combinations(const std::vector<SweptParameter>& swept) {
  std::set<std::string> names;
  std::uint64_t count = 1;
  for (const SweptParameter& each : swept) {
    if (!names.insert(each.name).second) throw UsageError(each.name + " is swept twice");
    count *= each.values.size();
    if (count > kMostSteps) throw UsageError("the sweep has more than 1000000 steps");
  }
  return count;
}

std::vector<double> combination(const std::vector<SweptParameter>& swept, std::uint64_t step) {
  std::vector<double> values(swept.size());
  std::uint64_t rest = step;
  for (std::size_t k = swept.size(); k-- > 0;) {
    const std::uint64_t count = swept[k].values.size();
    const std::uint64_t at = rest % count;
    rest /= count;
    values[k] = swept[k].values[rest % 2 == 0 ? at : count - 1 - at];  // odd `rest`: downwards
  }
  return values;
}

}  // namespace remeshd::cli
