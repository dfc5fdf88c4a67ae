#include "tests/campaign/tally.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "tests/campaign/median.h"

namespace remeshd::campaign {
namespace {

using nlohmann::json;

std::string decade(double size) {
  if (!(size > 0)) return "0";
  return "1e" + std::to_string(std::clamp(static_cast<int>(std::floor(std::log10(size))), -12, 3));
}

std::string range(std::size_t features) {
  if (features < 5) return "03-04";
  if (features < 10) return "05-09";
  if (features < 20) return "10-19";
  if (features < 30) return "20-29";
  return "30-40";
}

std::string percent(int part, int whole) {
  std::ostringstream text;
  text << part << " (" << std::fixed << std::setprecision(1)
       << (whole == 0 ? 0.0 : 100.0 * part / whole) << " %)";
  return text.str();
}

void print_counts(const char* what, const std::map<std::string, int>& counts, std::ostream& out) {
  out << "  " << std::left << std::setw(24) << what;
  if (counts.empty()) out << "none";
  const char* separator = "";
  for (const auto& [name, n] : counts) {
    out << separator << name << " " << n;
    separator = ", ";
  }
  out << "\n";
}

void print_results(const char* what, const Results& r, std::ostream& out) {
  if (r.runs == 0) return;
  out << what << ": " << r.runs << " runs, " << percent(r.valid, r.runs) << " valid, " << r.invalid
      << " invalid, " << r.crashes << " crashes, " << r.hangs << " hangs, "
      << percent(r.refused, r.runs) << " refused (" << r.unplaced
      << " without a feature and a place)\n";
  print_counts("refused because", r.reasons, out);
  print_counts("checks failed", r.checks, out);
  print_counts("ways", r.strategies, out);
  const double n = std::max(1, r.valid + r.invalid);
  out << "  " << std::left << std::setw(24) << "nodes inserted in" << r.inserted << " meshes\n"
      << "  " << std::setw(24) << "last resort in"
      << percent(r.with_last_resort, r.valid + r.invalid)
      << " meshes, of over a fifth of the tets in " << r.over_a_fifth << "\n"
      << "  " << std::setw(24) << "time" << std::setprecision(3) << "mean "
      << r.seconds / std::max(1, r.runs) << " s, verifier " << r.verifier_seconds / n
      << " s; of processors median " << median(r.times) << " s, most " << most(r.times) << " s\n"
      << "  " << std::setw(24) << "nodes kept, mean" << 100 * r.kept / n << " %, lost far away in "
      << percent(r.far_lost, r.valid + r.invalid) << " meshes\n"
      << "  " << std::setw(24) << "least angle" << r.least_angle << " degrees, below 5 in "
      << r.angle_below_5 << " meshes, away from sharp places " << r.away_angle << ", in "
      << r.away_below_5 << "; least volume-length " << r.least_quality << "\n";
}

json to_json(const Results& r) {
  return {{"runs", r.runs},
          {"valid", r.valid},
          {"invalid", r.invalid},
          {"crashes", r.crashes},
          {"hangs", r.hangs},
          {"refused", r.refused},
          {"unplaced", r.unplaced},
          {"inserted", r.inserted},
          {"seconds", r.seconds},
          {"verifier_seconds", r.verifier_seconds},
          {"kept", r.kept},
          {"least_angle", r.least_angle},
          {"least_quality", r.least_quality},
          {"angle_below_5", r.angle_below_5},
          {"away_angle", r.away_angle},
          {"away_below_5", r.away_below_5},
          {"far_lost", r.far_lost},
          {"with_last_resort", r.with_last_resort},
          {"over_a_fifth", r.over_a_fifth},
          {"median_time", median(r.times)},
          {"most_time", most(r.times)},
          {"reasons", r.reasons},
          {"checks", r.checks},
          {"ways", r.strategies}};
}

}  // namespace

void Results::add(const Outcome& o) {
  ++runs;
  seconds += o.seconds;
  if (o.kind == "crash" || o.kind == "exception") ++crashes;
  if (o.kind == "hang") ++hangs;
  if (o.kind == "refused") {
    ++refused;
    ++reasons[o.reason];
    unplaced += !o.placed;
  }
  if (o.kind == "invalid") {
    ++invalid;
    std::istringstream list(o.reason);
    for (std::string check; std::getline(list >> std::ws, check, ',');) ++checks[check];
  }
  valid += o.valid();
  if (o.kind != "crash" && o.kind != "exception" && o.kind != "hang")
    times.push_back(o.processor_seconds);
  if (o.kind != "valid" && o.kind != "invalid") return;
  ++strategies[o.strategy];
  inserted += o.inserted > 0;
  verifier_seconds += o.verifier_seconds;
  kept += o.kept;
  least_angle = std::min(least_angle, o.least_angle);
  least_quality = std::min(least_quality, o.least_quality);
  angle_below_5 += o.least_angle < 5;
  away_angle = std::min(away_angle, o.away_angle);
  away_below_5 += o.away_angle < 5;
  far_lost += o.lost.far > 0;
  if (o.strategy == "TetGen") return;
  with_last_resort += o.newly_last_resort > 0;
  over_a_fifth += o.newly_last_resort > part_goals::kLastResort;
}

void Tally::add(const WorkedCase& worked) {
  ++cases;
  gentle_cases += worked.gentle;
  for (const auto& [reason, n] : worked.discarded) discarded[reason] += n;
  part_figures.add(worked);
  const bool of_part = !worked.campaign_case.part.empty();
  for (const Outcome& o : worked.outcomes) {
    const StepFacts facts = o.step < worked.facts.size() ? worked.facts[o.step] : StepFacts{};
    if (o.step == 0) {
      (of_part ? first_parts : facts.good_natured ? first_good : first_rest).add(o);
      continue;
    }
    (of_part ? parts : facts.good_natured ? good : rest).add(o);
    ++edits;
    good_natured += facts.good_natured;
    unmeasured += !facts.measured;
    topology_changed += facts.topology_changed;
    tangent += facts.tangent;
    coincident += facts.coincident;
    wedge += facts.wedge;
    ++kinds[facts.kind];
    ++sizes[decade(facts.size)];
    ++feature_counts[range(facts.types.size())];
    for (const std::string& type : facts.types) ++types[type];
  }
}

void print(const Tally& t, std::ostream& out) {
  out << t.cases << " cases (" << t.gentle_cases << " made to be good-natured), " << t.edits
      << " edits\n";
  print_counts("feature types", t.types, out);
  print_counts("features per model", t.feature_counts, out);
  print_counts("edits", t.kinds, out);
  print_counts("sizes, by the diagonal", t.sizes, out);
  print_counts("models discarded", t.discarded, out);
  out << "  edits with tangent contacts " << percent(t.tangent, t.edits) << ", coincident faces "
      << percent(t.coincident, t.edits) << ", wedges " << percent(t.wedge, t.edits)
      << ", that change topology " << percent(t.topology_changed, t.edits) << "\n  good-natured "
      << percent(t.good_natured, t.edits) << ", not measured " << t.unmeasured << "\n";
  print_results("first meshes, good-natured", t.first_good, out);
  print_results("first meshes, others", t.first_rest, out);
  print_results("edits, good-natured", t.good, out);
  print_results("edits, others", t.rest, out);
  print_results("first meshes, detailed parts", t.first_parts, out);
  print_results("edits, detailed parts", t.parts, out);
  if (t.part_figures.edits > 0) print(t.part_figures, out);
}

json write_tally(const Tally& t) {
  return {{"cases", t.cases},
          {"gentle_cases", t.gentle_cases},
          {"edits", t.edits},
          {"good_natured", t.good_natured},
          {"unmeasured", t.unmeasured},
          {"topology_changed", t.topology_changed},
          {"tangent", t.tangent},
          {"coincident", t.coincident},
          {"wedge", t.wedge},
          {"types", t.types},
          {"kinds", t.kinds},
          {"sizes", t.sizes},
          {"feature_counts", t.feature_counts},
          {"discarded", t.discarded},
          {"first_good_natured", to_json(t.first_good)},
          {"first_others", to_json(t.first_rest)},
          {"edits_good_natured", to_json(t.good)},
          {"edits_others", to_json(t.rest)},
          {"first_parts", to_json(t.first_parts)},
          {"edits_parts", to_json(t.parts)},
          {"parts", write_figures(t.part_figures)}};
}

}  // namespace remeshd::campaign
