#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/sample.h"
#include "tests/bench/statistics.h"

namespace remeshd::bench {

/// `regular`, `remesh`, `paper` (the regular run as the paper has it), `single` or `chain` with the
/// iterations asked for: `remesh 10`, `regular auto`.
std::string series_name(std::string_view run, std::uint32_t iterations);

/// All runs of one case at one size.
struct Group {
  std::string name;         ///< `tool1-ac`; `plate-64` with so many features
  std::uint32_t nodes = 0;  ///< asked for
  /// By name, round by round; peers by theirs: `hxt`.
  std::map<std::string, std::vector<Sample>> series;

  /// A number of each round of a series; empty where there is no such series.
  template <class F>
  [[nodiscard]] Rounds rounds(const std::string& name_of_series, F&& number) const {
    Rounds values;
    const auto found = series.find(name_of_series);
    if (found == series.end()) return values;
    for (const Sample& s : found->second)
      values.push_back(s.failure.empty() ? std::optional<double>(number(s)) : std::nullopt);
    return values;
  }
  /// The median of a number over the rounds.
  template <class F>
  [[nodiscard]] std::optional<double> middle(const std::string& name_of_series, F&& number) const {
    return median(present(rounds(name_of_series, number)));
  }
  /// Median processor time, s.
  [[nodiscard]] std::optional<double> seconds(const std::string& name_of_series) const;
  /// Median of the pairwise ratios of processor time.
  [[nodiscard]] std::optional<double> ratio(const std::string& a, const std::string& b) const;
  /// The same from the model on: with the time for making the geometry.
  [[nodiscard]] std::optional<double> ratio_from_model(const std::string& a,
                                                       const std::string& b) const;
  /// The same of processor time a node.
  [[nodiscard]] std::optional<double> ratio_per_node(const std::string& a,
                                                     const std::string& b) const;
};

struct Results {
  std::string machine, date;
  std::vector<std::string> commands;  ///< that it was measured with, one after the other
  std::vector<Group> groups;

  /// Null where it was not measured.
  [[nodiscard]] const Group* find(std::string_view name, std::uint32_t nodes) const;
};

nlohmann::json write_results(const Results& results);
Results read_results(const nlohmann::json& document);

/// Processor, cores and memory, and the system's name.
std::string this_machine();
/// `2009-08-13`.
std::string today();

}  // namespace remeshd::bench
