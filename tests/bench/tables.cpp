#include "tests/bench/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "tests/bench/paper_figures.h"
#include "tests/bench/peers.h"
#include "tests/bench/sized_table.h"

namespace remeshd::bench {

std::string row(const Cells& cells) { return fmt::format("| {} |\n", fmt::join(cells, " | ")); }

namespace {

/// The first column is text, the others are numbers.
std::string head(const Cells& names) {
  std::string rule = "|---|";
  for (std::size_t k = 1; k < names.size(); ++k) rule += "---:|";
  return row(names) + rule + "\n";
}

std::string number(const std::optional<double>& x, int digits) {
  return x ? fmt::format("{:.{}f}", *x, digits) : "–";
}

std::string percent(const std::optional<double>& x, int digits = 1) {
  return x ? fmt::format("{:.{}f}", 100 * *x, digits) : "–";
}

/// 15,000
std::string count(const std::optional<double>& x) {
  if (!x) return "–";
  std::string digits = fmt::format("{:.0f}", *x);
  for (int k = static_cast<int>(digits.size()) - 3; k > 0; k -= 3) digits.insert(k, ",");
  return digits;
}

std::string megabytes(const std::optional<double>& bytes) {
  return bytes ? fmt::format("{:.0f}", *bytes / 1e6) : "–";
}

/// The iterations that a group has runs of, `auto` (0) last.
std::vector<std::uint32_t> iterations_of(const Group& group) {
  std::set<std::uint32_t> found;
  for (const auto& [name, samples] : group.series) {
    const std::size_t blank = name.find(' ');
    if (blank == std::string::npos) continue;
    const std::string which = name.substr(blank + 1);
    found.insert(which == "auto" ? UINT32_MAX : static_cast<std::uint32_t>(std::stoul(which)));
  }
  std::vector<std::uint32_t> result(found.begin(), found.end());
  for (std::uint32_t& k : result)
    if (k == UINT32_MAX) k = 0;
  return result;
}

constexpr auto kNodes = [](const Sample& s) { return s.nodes; };
constexpr auto kIterations = [](const Sample& s) { return s.iterations; };
constexpr auto kPeak = [](const Sample& s) { return s.peak_bytes; };
constexpr auto kMean = [](const Sample& s) { return s.quality.volume_length_mean; };
constexpr auto kLeast = [](const Sample& s) { return s.quality.volume_length_min; };
constexpr auto kSmallest = [](const Sample& s) { return s.quality.dihedral_min; };
constexpr auto kLargest = [](const Sample& s) { return s.quality.dihedral_max; };

/// Why runs of a group failed, each reason once.
std::string failures(const Results& results) {
  std::string text;
  for (const Group& group : results.groups)
    for (const auto& [name, samples] : group.series) {
      std::map<std::string, int> reasons;
      for (const Sample& s : samples)
        if (!s.failure.empty()) ++reasons[s.failure];
      for (const auto& [reason, times] : reasons)
        text += fmt::format("- {} {} {}, {} of {}: {}\n", group.name, group.nodes, name, times,
                            samples.size(), reason);
    }
  return text;
}

/// Ours over a peer's time; a node where its mesh is not as large.
std::string against(const Group& group, const std::string& ours, const std::string& peer,
                    int digits) {
  const auto a = group.middle(ours, kNodes), b = group.middle(peer, kNodes);
  if (!a || !b) return "–";
  // Twice: the peer's nodes are those of the first run that was measured.
  if (std::fabs(*b / *a - 1) <= 2 * kSameNodes) return number(group.ratio(ours, peer), digits);
  return number(group.ratio_per_node(ours, peer), digits) + " a node";
}

std::string goal_number(const Goal& goal, const std::optional<double>& x) {
  switch (goal.unit) {
    case Goal::Unit::Percent:
      return x ? percent(x) + " %" : "–";
    case Goal::Unit::Bytes:
      return x ? count(x) + " B" : "–";
    case Goal::Unit::Ratio:
      break;
  }
  return number(x, 2);
}

std::string word(Outcome outcome) {
  switch (outcome) {
    case Outcome::StretchMet:
      return "met, stretch too";
    case Outcome::Met:
      return "met";
    case Outcome::Missed:
      return "**missed**";
    case Outcome::NotMeasured:
      break;
  }
  return "";
}

}  // namespace

std::string timing_table(const Results& results) {
  std::string text = head({"case",     "nodes",     "iterations", "regular s",  "remesh s",
                           "% of it",  "paper's %", "phi %",      "as paper s", "remesh % of that",
                           "t1",       "t2",        "t3",         "t4",         "t5",
                           "t6",       "t7",        "t8",         "peak MB",    "remesh peak MB",
                           "mean v-l", "remesh",    "least v-l",  "remesh",     "least angle",
                           "remesh"});
  for (const Group& group : results.groups)
    for (const std::uint32_t k : iterations_of(group)) {
      const std::string regular = series_name("regular", k), remesh = series_name("remesh", k),
                        paper = series_name("paper", k);
      const auto phase = [&](const std::string& series, double Phases::*t) {
        return number(group.middle(series, [&](const Sample& s) { return s.phases.*t; }), 3);
      };
      std::string turns = std::to_string(k);
      if (k == 0)
        turns = fmt::format("auto ({}, {})", number(group.middle(regular, kIterations), 0),
                            number(group.middle(remesh, kIterations), 0));
      text += row({group.name,
                   count(group.middle(remesh, kNodes)),
                   turns,
                   number(group.seconds(regular), 3),
                   number(group.seconds(remesh), 3),
                   "**" + percent(group.ratio(remesh, regular)) + "**",
                   percent(paper_ratio(group.name, group.nodes, k)),
                   percent(group.middle(remesh, [](const Sample& s) { return s.free_share; })),
                   number(group.seconds(paper), 3),
                   percent(group.ratio(remesh, paper)),
                   phase(regular, &Phases::setup),
                   phase(regular, &Phases::optimise),
                   phase(regular, &Phases::extract),
                   phase(remesh, &Phases::difference),
                   phase(remesh, &Phases::copy),
                   phase(remesh, &Phases::setup),
                   phase(remesh, &Phases::optimise),
                   phase(remesh, &Phases::extract),
                   megabytes(group.middle(regular, kPeak)),
                   megabytes(group.middle(remesh, kPeak)),
                   number(group.middle(regular, kMean), 3),
                   number(group.middle(remesh, kMean), 3),
                   number(group.middle(regular, kLeast), 3),
                   number(group.middle(remesh, kLeast), 3),
                   number(group.middle(regular, kSmallest), 1),
                   number(group.middle(remesh, kSmallest), 1)});
    }
  return text;
}

std::string peer_table(const Results& results) {
  std::string text = head({"case", "mesher", "nodes", "tets", "s", "surface s", "import s",
                           "regular auto / it", "remesh auto / it", "peak MB", "mean v-l",
                           "least v-l", "least angle", "largest angle"});
  for (const Group& group : results.groups) {
    const bool any = std::ranges::any_of(
        all_peers(), [&](const Peer& peer) { return group.series.contains(peer.name); });
    if (!any) continue;
    std::vector<std::pair<std::string, std::string>> meshers{{"regular auto", "ours, regular"},
                                                             {"remesh auto", "ours, remesh"}};
    for (const Peer& peer : all_peers()) meshers.emplace_back(peer.name, peer.title);
    for (const auto& [series, title] : meshers) {
      if (!group.series.contains(series)) continue;
      const bool ours = series.ends_with("auto");
      text += row(
          {group.name, title, count(group.middle(series, kNodes)),
           count(group.middle(series, [](const Sample& s) { return s.tets; })),
           number(group.seconds(series), 3),
           ours ? "" : number(group.middle(series, [](const Sample& s) { return s.surface; }), 3),
           ours ? "" : number(group.middle(series, [](const Sample& s) { return s.import; }), 3),
           ours ? "" : against(group, "regular auto", series, 2),
           ours ? "" : against(group, "remesh auto", series, 3),
           megabytes(group.middle(series, kPeak)), number(group.middle(series, kMean), 3),
           number(group.middle(series, kLeast), 3), number(group.middle(series, kSmallest), 1),
           number(group.middle(series, kLargest), 1)});
    }
  }
  return text;
}

std::string chain_table(const Results& results) {
  const Cells names{"case",
                    "nodes",
                    "single edit s",
                    "edit of the chain s",
                    "chain / single",
                    "ways",
                    "bytes a node and revision"};
  std::string text;
  for (const Group& group : results.groups) {
    const auto chain = group.series.find("chain");
    if (chain == group.series.end() || chain->second.empty()) continue;
    text += row(
        {group.name, count(group.middle("chain", kNodes)), number(group.seconds("single"), 3),
         number(group.seconds("chain"), 3), number(group.ratio("chain", "single"), 2),
         chain->second.front().strategy,
         count(group.middle("chain", [](const Sample& s) { return s.retained_bytes / s.nodes; }))});
  }
  return text.empty() ? text : head(names) + text;
}

std::string goal_table(const std::vector<Goal>& goals) {
  std::map<Outcome, int> counts;
  for (const Goal& goal : goals) ++counts[goal.outcome()];
  std::string text = fmt::format(
      "{} goals: {} met, {} of them with their stretch goal, {} missed, {} not measured.\n\n",
      goals.size(), counts[Outcome::Met] + counts[Outcome::StretchMet], counts[Outcome::StretchMet],
      counts[Outcome::Missed], counts[Outcome::NotMeasured]);
  text += head({"goal", "case", "measured", "at most", "stretch", "outcome"});
  std::string missing, last;
  for (const Goal& goal : goals) {
    if (goal.outcome() == Outcome::NotMeasured) {
      missing += goal.group == last ? ", " : (last.empty() ? "" : "; ") + goal.group + " of ";
      missing += goal.where;
      last = goal.group;
      continue;
    }
    text +=
        row({goal.group, goal.where, goal_number(goal, goal.measured),
             goal_number(goal, goal.limit), goal_number(goal, goal.stretch), word(goal.outcome())});
  }
  if (!missing.empty()) text += "\nNot measured: " + missing + ".\n";
  return text;
}

std::optional<std::string> between_marks(const std::string& document, const std::string& tables) {
  const std::size_t begin = document.find(kBeginMark), end = document.find(kEndMark);
  if (begin == std::string::npos || end == std::string::npos || end < begin) return {};
  return document.substr(0, begin) + kBeginMark + "\n" + tables + document.substr(end);
}

std::string report(const Results& results, bool sized) {
  std::string text = fmt::format("{}, {}:\n\n    {}\n\n", results.machine, results.date,
                                 fmt::join(results.commands, "\n    "));
  if (sized) {
    text += "### Meshes sized by the rules\n\n" + sized_table(results);
    if (const std::string failed = failures(results); !failed.empty())
      text += "\n### What failed\n\n" + failed;
    return text;
  }
  text += "### Remesh and regular run\n\n" + timing_table(results);
  const std::string peers = peer_table(results);
  if (std::ranges::count(peers, '\n') > 2) text += "\n### Peers\n\n" + peers;
  if (const std::string chains = chain_table(results); !chains.empty())
    text += "\n### Chains of edits\n\n" + chains;
  if (const std::string failed = failures(results); !failed.empty())
    text += "\n### What failed\n\n" + failed;
  return text;
}

}  // namespace remeshd::bench
