#include "tests/campaign/run_case.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <span>
#include <vector>

#include "engine/base/error.h"
#include "tests/campaign/verifier/verifier.h"
#include "tests/support/strategy_name.h"

namespace remeshd::campaign {
namespace {

constexpr double kRounding = 1e-9;  // of a share

using nlohmann::json;

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Of this process and of helpers that have ended.
double processor_seconds() {
  double sum = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    ::getrusage(who, &usage);
    for (const timeval& t : {usage.ru_utime, usage.ru_stime})
      sum += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  }
  return sum;
}

/// Since it was made.
class Watch {
 public:
  void tell(Outcome& outcome) const {
    outcome.seconds = since(start_);
    outcome.processor_seconds = processor_seconds() - processor_start_;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double processor_start_ = processor_seconds();
};

/// A revision with the permanent ids that it and its ancestors have had.
struct Base {
  Revision revision;
  std::set<std::uint64_t> node_ids, tet_ids;
};

void describe(const Findings& findings, Outcome& outcome) {
  for (const auto& [check, entry] : findings.entries()) {
    outcome.reason += (outcome.reason.empty() ? "" : ", ") + check;
    outcome.message += (outcome.message.empty() ? "" : "; ") + check + ": " + entry.first + " (" +
                       std::to_string(entry.count) + " times)";
  }
}

void describe(const Error& failure, Outcome& outcome) {
  static const std::regex kPlace(R"(\(-?[0-9.e+-]+, -?[0-9.e+-]+, -?[0-9.e+-]+\))");
  outcome.kind = "refused";
  outcome.reason = failure.info().reason;
  outcome.message = failure.what();
  std::string features;
  for (const std::string& id : failure.info().features)
    features += (features.empty() ? "" : ",") + id;
  if (!features.empty()) outcome.message += " [" + features + "]";
  outcome.placed = !features.empty() && std::regex_search(failure.info().message, kPlace);
}

/// What was told as certain before there was a mesh has to stand in its report.
void check_foretold(std::span<const Warning> certain, const Report& report, Findings& findings) {
  for (const Warning& warning : certain)
    if (std::ranges::none_of(report.warnings, [&](const Warning& told) {
          return told.code == warning.code && told.message == warning.message;
        }))
      findings.add("foretold", warning.message);
}

/// Share of the tets that a last resort made anew; the report counts those of the base that it kept
/// by their base's share.
double newly_last_resort(const Report& report, const Revision* base) {
  const double inherited =
      base == nullptr || report.counts.tets == 0
          ? 0
          : base->report.last_resort_share * report.counts.tets_kept / report.counts.tets;
  const double anew = report.last_resort_share - inherited;
  return anew > kRounding ? anew : 0;
}

Outcome try_step(std::size_t step, const ModelSource& model, const MeshOptions& options,
                 std::unique_ptr<Base>& base) {
  Outcome outcome{.step = step, .kind = "valid"};
  const Watch watch;
  try {
    auto next = std::make_unique<Base>();
    std::vector<Warning> certain;
    Run run;
    run.on_warnings = [&](std::span<const Warning> warnings) {
      certain.insert(certain.end(), warnings.begin(), warnings.end());
    };
    next->revision = make_revision(base ? base->revision : Revision::none(), model, options, run);
    watch.tell(outcome);
    const Report& report = next->revision.report;
    outcome.strategy = test::name_of(report.strategy);
    outcome.inserted = static_cast<int>(report.counts.nodes_inserted);
    outcome.nodes = static_cast<int>(report.counts.nodes);
    outcome.kept =
        report.counts.nodes == 0 ? 0.0 : 1.0 * report.counts.nodes_kept / report.counts.nodes;
    outcome.least_angle = report.quality.dihedral_min;
    outcome.away_angle = report.quality_away.dihedral_min;
    outcome.last_resort = report.last_resort_share;
    outcome.newly_last_resort = newly_last_resort(report, base ? &base->revision : nullptr);
    outcome.least_quality = report.quality.volume_length_min;
    if (base) {
      next->node_ids = base->node_ids;
      next->tet_ids = base->tet_ids;
    }
    const auto made = std::chrono::steady_clock::now();
    Findings findings = verify_independently(next->revision, base ? &base->revision : nullptr,
                                             next->node_ids, next->tet_ids);
    outcome.verifier_seconds = since(made);
    check_foretold(certain, report, findings);
    if (base) outcome.lost = lost_nodes(base->revision, next->revision);
    if (findings.empty()) {
      base = std::move(next);
    } else {
      outcome.kind = "invalid";
      describe(findings, outcome);
    }
  } catch (const Error& failure) {
    watch.tell(outcome);
    describe(failure, outcome);
  } catch (const std::exception& failure) {
    outcome.kind = "exception";
    outcome.reason = failure.what();
  }
  return outcome;
}

}  // namespace

json write_outcome(const Outcome& o) {
  return {{"step", o.step},
          {"kind", o.kind},
          {"reason", o.reason},
          {"message", o.message},
          {"placed", o.placed},
          {"way", o.strategy},
          {"inserted", o.inserted},
          {"seconds", o.seconds},
          {"processor_seconds", o.processor_seconds},
          {"verifier_seconds", o.verifier_seconds},
          {"least_angle", o.least_angle},
          {"least_quality", o.least_quality},
          {"nodes", o.nodes},
          {"kept", o.kept},
          {"away_angle", o.away_angle},
          {"last_resort", o.last_resort},
          {"newly_last_resort", o.newly_last_resort},
          {"lost", o.lost.all},
          {"lost_far", o.lost.far},
          {"furthest_lost", o.lost.furthest}};
}

Outcome read_outcome(const json& j) {
  Outcome o;
  j.at("step").get_to(o.step);
  j.at("kind").get_to(o.kind);
  j.at("reason").get_to(o.reason);
  j.at("message").get_to(o.message);
  j.at("placed").get_to(o.placed);
  j.at("way").get_to(o.strategy);
  j.at("inserted").get_to(o.inserted);
  j.at("seconds").get_to(o.seconds);
  j.at("processor_seconds").get_to(o.processor_seconds);
  j.at("verifier_seconds").get_to(o.verifier_seconds);
  j.at("least_angle").get_to(o.least_angle);
  j.at("least_quality").get_to(o.least_quality);
  j.at("nodes").get_to(o.nodes);
  j.at("kept").get_to(o.kept);
  j.at("away_angle").get_to(o.away_angle);
  j.at("last_resort").get_to(o.last_resort);
  j.at("newly_last_resort").get_to(o.newly_last_resort);
  j.at("lost").get_to(o.lost.all);
  j.at("lost_far").get_to(o.lost.far);
  j.at("furthest_lost").get_to(o.lost.furthest);
  return o;
}

void run_case(const CampaignCase& c, const std::function<void(std::size_t)>& before,
              const std::function<void(const Outcome&)>& after) {
  std::unique_ptr<Base> base;
  MeshOptions inherited = c.options;
  inherited.nodes.reset();
  inherited.size.reset();
  for (std::size_t step = 0; step <= c.steps.size(); ++step) {
    before(step);
    after(try_step(step, model_after(c, step), step == 0 ? c.options : inherited, base));
    if (!base) return;
  }
}

}  // namespace remeshd::campaign
