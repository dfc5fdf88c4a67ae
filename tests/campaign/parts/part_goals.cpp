#include "tests/campaign/parts/part_goals.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "tests/campaign/median.h"

namespace remeshd::campaign {
namespace {

std::string rounded(double v) {
  std::ostringstream text;
  text << std::setprecision(3) << v;
  return text.str();
}

std::string share(double part, int whole) {
  return rounded(whole == 0 ? 0.0 : 100 * part / whole) + " %";
}

/// One that can be made again with `--seed` and `--case`.
std::string name_of(const CampaignCase& c, const Outcome& o) {
  std::string name = c.part + " " + std::to_string(c.seed) + "-" + std::to_string(c.number) + "-" +
                     std::to_string(o.step);
  if (o.step > 0 && o.step <= c.steps.size()) name += " (" + c.steps[o.step - 1].kind + ")";
  return name;
}

void print_row(const char* what, const std::string& value, const char* goal, std::ostream& out) {
  out << "  " << std::left << std::setw(26) << what << std::setw(42) << value << "goal: " << goal
      << "\n";
}

void print_misses(const PartFigures& figures, std::ostream& out) {
  constexpr std::size_t kShown = 20;
  for (const auto& [goal, list] : figures.misses) {
    out << goal << ", by part, seed, case and step:\n";
    for (std::size_t k = 0; k < std::min(kShown, list.size()); ++k) out << "  " << list[k] << "\n";
    if (list.size() > kShown) out << "  and " << list.size() - kShown << " more\n";
  }
}

}  // namespace

void PartFigures::add(const WorkedCase& worked) {
  const CampaignCase& c = worked.campaign_case;
  if (c.part.empty()) return;
  double first_seconds = 0;
  for (const Outcome& o : worked.outcomes) {
    if (o.step == 0) first_seconds = o.processor_seconds;
    if (o.step > 0) add(c, o, first_seconds);
  }
}

void PartFigures::add(const CampaignCase& c, const Outcome& o, double first_seconds) {
  const auto miss = [&](const char* goal, const std::string& more) {
    misses[goal].push_back(name_of(c, o) + (more.empty() ? "" : ": ") + more);
  };
  ++edits;
  ++parts[c.part];
  if (o.kind == "invalid") ++invalid, miss("invalid", o.message);
  if (o.kind == "crash" || o.kind == "exception") ++crashes, miss("crashed", o.reason);
  if (o.kind == "hang") ++hangs, miss("took too long", o.message);
  if (o.kind == "refused") ++refused, miss("refused", o.reason + ": " + o.message);
  const bool ended = o.valid() || o.kind == "invalid" || o.kind == "refused";
  if (ended && first_seconds > 0) {
    const double time = o.processor_seconds / first_seconds;
    times.push_back(time);
    if (time > part_goals::kMostTime) miss("slow", rounded(time) + " first meshes, " + o.strategy);
  }
  if (!o.valid()) return;
  ++meshes;
  kept += o.kept;
  away_angle = std::min(away_angle, o.away_angle);
  if (o.strategy == "TetGen") {
    ++tetgen;
    miss("by TetGen", "");
  } else {
    last_resort += o.last_resort;
    most_last_resort = std::max(most_last_resort, o.newly_last_resort);
    if (o.newly_last_resort > 0) ++with_last_resort;
    if (o.newly_last_resort > part_goals::kLastResort)
      miss("last resort of many tets", rounded(o.newly_last_resort) + ", " + o.strategy);
  }
  if (o.lost.far == 0) return;
  ++far_lost;
  ++far_lost_by_way[o.strategy];
  furthest = std::max(furthest, o.lost.furthest);
  miss("lost nodes far from its change", std::to_string(o.lost.far) + " of " +
                                             std::to_string(o.lost.all) + ", up to " +
                                             rounded(o.lost.furthest) + " lengths, " + o.strategy);
}

double PartFigures::median_time() const { return median(times); }

double PartFigures::most_time() const { return most(times); }

void print(const PartFigures& f, std::ostream& out) {
  const auto count = [](int n) { return std::to_string(n); };
  out << "detailed parts: " << f.edits << " edits";
  for (const auto& [part, n] : f.parts) out << ", " << part << " " << n;
  out << "\n";
  print_row("invalid meshes", count(f.invalid), "0", out);
  print_row("crashes, hangs", count(f.crashes) + ", " + count(f.hangs), "0, 0", out);
  print_row("refused", count(f.refused) + " (" + share(f.refused, f.edits) + ")",
            "each by name and place", out);
  print_row("TetGen of the whole part", count(f.tetgen) + " (" + share(f.tetgen, f.meshes) + ")",
            "0", out);
  print_row("last resort elsewhere",
            "in " + count(f.with_last_resort) + " (" + share(f.with_last_resort, f.meshes) +
                "), most " + share(f.most_last_resort, 1) + " of the tets",
            ".5 % of the edits, at most 20 %", out);
  print_row("nodes lost far away",
            "in " + count(f.far_lost) + " (" + share(f.far_lost, f.meshes) + "), up to " +
                rounded(f.furthest) + " lengths",
            "1 % of the edits, beyond 6", out);
  for (const auto& [way, n] : f.far_lost_by_way) out << "    of them " << way << " " << n << "\n";
  print_row("time by the first mesh's",
            "median " + rounded(f.median_time()) + ", most " + rounded(f.most_time()),
            "median .3, none over 3", out);
  print_row("least angle, sharp apart", rounded(f.meshes == 0 ? 0 : f.away_angle) + " degrees",
            "the more the better", out);
  print_row("nodes kept, mean", share(f.kept, f.meshes), "the more the better", out);
  print_misses(f, out);
}

nlohmann::json write_figures(const PartFigures& f) {
  return {{"edits", f.edits},
          {"meshes", f.meshes},
          {"invalid", f.invalid},
          {"crashes", f.crashes},
          {"hangs", f.hangs},
          {"refused", f.refused},
          {"tetgen", f.tetgen},
          {"with_last_resort", f.with_last_resort},
          {"last_resort", f.last_resort},
          {"most_last_resort", f.most_last_resort},
          {"far_lost", f.far_lost},
          {"furthest_lost", f.furthest},
          {"away_angle", f.away_angle},
          {"kept", f.kept},
          {"median_time", f.median_time()},
          {"most_time", f.most_time()},
          {"parts", f.parts},
          {"far_lost_by_way", f.far_lost_by_way},
          {"misses", f.misses}};
}

}  // namespace remeshd::campaign
