#include "tests/bench/engine_run.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "engine/base/error.h"
#include "tests/bench/statistics.h"
#include "tests/support/cases.h"
#include "tests/support/changed_places.h"
#include "tests/support/child_process.h"
#include "tests/support/circle_edges.h"
#include "tests/support/documents.h"
#include "tests/support/strategy_name.h"

namespace remeshd::bench {
namespace {

using nlohmann::json;

constexpr double kFarLengths = 4;  // from a change: nodes beyond are to be kept

NLOHMANN_JSON_SERIALIZE_ENUM(RunKind, {{RunKind::Regular, "regular"},
                                       {RunKind::Remesh, "remesh"},
                                       {RunKind::Chain, "chain"}})

json write_run(const EngineRun& run) {
  return {{"kind", run.kind},
          {"original", run.original},
          {"modified", run.modified},
          {"nodes", run.nodes},
          {"iterations", run.iterations},
          {"seed", run.seed},
          {"paper", run.switches.paper},
          {"length", run.length},
          {"sized", run.sized}};
}

EngineRun read_run(const json& j) {
  EngineRun run;
  j.at("kind").get_to(run.kind);
  j.at("original").get_to(run.original);
  j.at("modified").get_to(run.modified);
  j.at("nodes").get_to(run.nodes);
  j.at("iterations").get_to(run.iterations);
  j.at("seed").get_to(run.seed);
  j.at("paper").get_to(run.switches.paper);
  j.at("length").get_to(run.length);
  j.at("sized").get_to(run.sized);
  return run;
}

ModelSource model_of_file(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot open " + file);
  return test::read_model(json::parse(in));
}

/// All of a sample that the revision tells.
Sample sample_of(const Revision& revision) {
  const Report& report = revision.report;
  Sample s;
  const PhaseSeconds& t = report.seconds;
  s.phases = {.setup = t.setup,
              .optimise = t.optimise,
              .extract = t.extract,
              .difference = t.difference,
              .copy = t.copy};
  s.nodes = report.counts.nodes;
  s.tets = report.counts.tets;
  s.iterations = report.counts.iterations;
  s.free_share = report.free_share;
  s.strategy = test::name_of(report.strategy);
  s.quality = report.quality;
  s.away_mean = report.quality_away.volume_length_mean;
  s.away_angle = report.quality_away.dihedral_min;
  s.kept = report.counts.nodes_kept / static_cast<double>(report.counts.nodes);
  if (const double edges = test::fewest_edges_on_circles(revision); std::isfinite(edges))
    s.circle_edges = edges;
  return s;
}

/// Makes revisions and takes their time.
class Workshop {
 public:
  /// A first small mesh, so that no measured one pays for what the libraries do once.
  Workshop() {
    make_revision(Revision::none(), test::one_feature(test::block("block", 2, 2, 2)),
                  {.nodes = 300}, Run{});
    meter_.emplace();
  }

  Revision make(const Revision& original, const ModelSource& source, const MeshOptions& options,
                Sample& sample) {
    meter_->start();
    Revision revision = make_revision(original, source, options, Run{});
    Sample time;
    meter_->stop(time);
    sample = sample_of(revision);
    sample.cpu = time.cpu;
    sample.wall = time.wall;
    sample.peak_bytes = time.peak_bytes;
    return revision;
  }

 private:
  std::optional<Meter> meter_;
};

/// An edit keeps the density of its base.
MeshOptions inherited(MeshOptions options) {
  options.nodes.reset();
  return options;
}

Samples run_regular(const EngineRun& run) {
  const ModelSource modified = model_of_file(run.modified);
  Workshop workshop;
  Samples samples;
  workshop.make(Revision::none(), modified, mesh_options(run), samples["regular"]);
  return samples;
}

Samples run_remesh(const EngineRun& run) {
  const ModelSource original = model_of_file(run.original), modified = model_of_file(run.modified);
  Workshop workshop;
  Samples samples;
  const MeshOptions options = mesh_options(run);
  const Revision base = workshop.make(Revision::none(), original, options, samples["first"]);
  Sample& edit = samples["remesh"];
  const Revision edited = workshop.make(base, modified, inherited(options), edit);
  if (run.sized) {
    const test::KeptShares shares = test::kept_shares(base, edited, kFarLengths);
    edit.base_kept = shares.kept;
    edit.base_far = shares.far;
  }
  return samples;
}

/// The single edit is the mean of the two ways, each from a regular mesh, because the chain goes
/// both.
Samples run_chain(const EngineRun& run) {
  constexpr int kSingles = 3;
  const ModelSource original = model_of_file(run.original), modified = model_of_file(run.modified);
  Workshop workshop;
  MeshOptions options = mesh_options(run);
  Samples samples;
  Sample made;
  const Revision base = workshop.make(Revision::none(), original, options, made);
  std::vector<double> there, back;
  for (int k = 0; k < kSingles; ++k) {
    workshop.make(base, modified, inherited(options), samples["single"]);
    there.push_back(samples["single"].cpu);
  }
  {
    MeshOptions same = options;
    same.nodes = samples["single"].nodes;
    const Revision end = workshop.make(Revision::none(), modified, same, made);
    for (int k = 0; k < kSingles; ++k) {
      workshop.make(end, original, inherited(same), made);
      back.push_back(made.cpu);
    }
  }
  samples["single"].cpu = 0.5 * (*median(there) + *median(back));

  Sample& chain = samples["chain"];
  std::deque<Revision> revisions;
  std::map<std::string, int> strategies;
  double cpu = 0, wall = 0, nodes = 0, peak = 0, after_first = 0;
  for (int k = 1; k <= run.length; ++k) {
    const Revision& from = revisions.empty() ? base : revisions.back();
    Revision next = workshop.make(from, k % 2 != 0 ? modified : original, inherited(options), made);
    revisions.push_back(std::move(next));
    cpu += made.cpu;
    wall += made.wall;
    nodes += made.nodes;
    peak = std::max(peak, made.peak_bytes);
    ++strategies[made.strategy];
    malloc_trim(0);  // what is free does not stay with a revision
    if (k == 1) after_first = resident_bytes();
  }
  chain = made;
  chain.cpu = cpu / run.length;
  chain.wall = wall / run.length;
  chain.nodes = nodes / run.length;
  chain.peak_bytes = peak;
  chain.strategy.clear();
  for (const auto& [way, n] : strategies)
    chain.strategy += (chain.strategy.empty() ? "" : ", ") + std::to_string(n) + " " + way;
  if (run.length > 1) chain.retained_bytes = (resident_bytes() - after_first) / (run.length - 1);
  return samples;
}

Samples run_here(const EngineRun& run) {
  switch (run.kind) {
    case RunKind::Regular:
      return run_regular(run);
    case RunKind::Remesh:
      return run_remesh(run);
    case RunKind::Chain:
      break;
  }
  return run_chain(run);
}

Samples all_failed(const EngineRun& run, const std::string& why) {
  const Sample failed{.failure = why};
  switch (run.kind) {
    case RunKind::Regular:
      return {{"regular", failed}};
    case RunKind::Remesh:
      return {{"first", failed}, {"remesh", failed}};
    case RunKind::Chain:
      break;
  }
  return {{"single", failed}, {"chain", failed}};
}

}  // namespace

MeshOptions mesh_options(const EngineRun& run) {
  MeshOptions options{.nodes = run.nodes, .iterations = run.iterations, .seed = run.seed};
  options.sizing.even = !run.sized;
  if (run.switches.paper) {
    options.start = MeshOptions::Start::Random;
    options.rebuild = true;
  }
  return options;
}

std::string work(const std::string& request) {
  const EngineRun run = read_run(json::parse(request));
  Samples samples;
  try {
    samples = run_here(run);
  } catch (const Error& e) {
    samples = all_failed(run, e.info().reason + ": " + e.what());
  }
  json answer;
  for (const auto& [name, sample] : samples) answer[name] = write_sample(sample);
  return answer.dump();
}

Samples measure(const EngineRun& run, double seconds) {
  const test::ChildEnd child = test::run_child(
      test::kThisProgram, {"remesh-bench", kWorkCommand, write_run(run).dump()}, seconds);
  const json answer = json::parse(child.output, nullptr, false);
  if (!child.well() || answer.is_discarded())
    return all_failed(run, child.how() + ": " + child.errors);
  Samples samples;
  for (const auto& [name, sample] : answer.items()) samples[name] = read_sample(sample);
  return samples;
}

}  // namespace remeshd::bench
