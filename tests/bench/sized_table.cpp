#include "tests/bench/sized_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "tests/bench/peers.h"
#include "tests/bench/tables.h"

namespace remeshd::bench {
namespace {

/// Of all rounds that went well; nothing where none did.
template <class F>
std::optional<double> least(const std::vector<Sample>& samples, F&& number) {
  std::optional<double> result;
  for (const Sample& s : samples)
    if (s.failure.empty()) result = std::fmin(result.value_or(HUGE_VAL), number(s));
  return result;
}

std::string text(const std::optional<double>& x, int digits, double factor = 1) {
  return x ? fmt::format("{:.{}f}", factor * *x, digits) : "–";
}

/// The ways of the rounds, each once.
std::string ways(const std::vector<Sample>& samples) {
  std::set<std::string> all;
  for (const Sample& s : samples) all.insert(s.failure.empty() ? s.strategy : "failed");
  return fmt::format("{}", fmt::join(all, ", "));
}

/// The largest deviation of a round's count from what was asked for.
std::optional<double> off(const std::vector<Sample>& samples, double asked) {
  const auto near = least(samples, [&](const Sample& s) { return -std::fabs(s.nodes - asked); });
  return near ? std::optional<double>(-*near / asked) : std::nullopt;
}

/// Shares of the base's nodes, kept and far from the change, of the round with the least margin.
std::string base_shares(const std::vector<Sample>& samples) {
  const auto margin = [](const Sample& s) {
    return s.failure.empty() ? s.base_kept - s.base_far : HUGE_VAL;
  };
  const auto worst = std::ranges::min_element(samples, {}, margin);
  if (worst == samples.end() || !worst->failure.empty()) return "–";
  return fmt::format("{:.1f}, {:.1f}", 100 * worst->base_kept, 100 * worst->base_far);
}

}  // namespace

std::string sized_table(const Results& results) {
  std::string rows;
  for (const Group& group : results.groups) {
    std::vector<std::pair<std::string, std::string>> series{
        {"first 10", "first"}, {"remesh 10", "edit"}, {"regular 10", "regular"}};
    for (const Peer& peer : all_peers()) series.emplace_back(peer.name, peer.title);
    for (const auto& [name, title] : series) {
      const auto found = group.series.find(name);
      if (found == group.series.end()) continue;
      const std::vector<Sample>& samples = found->second;
      const bool ours = name.ends_with(" 10"), edit = name == "remesh 10";
      const auto mean = [](const Sample& s) { return s.quality.volume_length_mean; };
      const auto angle = [](const Sample& s) { return s.quality.dihedral_min; };
      const auto nodes = group.middle(name, [](const Sample& s) { return s.nodes; });
      rows +=
          row({group.name, fmt::format("{}", group.nodes), title, text(nodes, 0),
               name == "first 10" ? text(off(samples, group.nodes), 1, 100) : "",
               text(group.seconds(name), 2), text(group.ratio(name, "hxt"), 2),
               text(group.ratio_from_model(name, "hxt"), 2), text(least(samples, mean), 3),
               text(least(samples, angle), 1),
               ours ? text(least(samples, [](const Sample& s) { return s.away_mean; }), 3) : "",
               ours ? text(least(samples, [](const Sample& s) { return s.away_angle; }), 1) : "",
               ours ? text(least(samples, [](const Sample& s) { return s.circle_edges; }), 1) : "",
               edit ? text(least(samples, [](const Sample& s) { return s.kept; }), 1, 100) : "",
               edit ? base_shares(samples) : "", ours ? ways(samples) : ""});
    }
  }
  return row({"case", "asked", "mesh", "nodes", "off %", "s", "of HXT's", "from the model",
              "mean v-l", "least angle", "mean away", "angle away", "edges a circle", "kept %",
              "of the base: kept, far %", "ways"}) +
         "|---|---:|---|---:|" + "---:|---:|---:|---:|---:|---:|---:|---:|---:|---|---|\n" + rows;
}

}  // namespace remeshd::bench
