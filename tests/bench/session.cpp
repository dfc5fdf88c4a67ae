#include "tests/bench/session.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "engine/cellular/cellular_model.h"
#include "engine/nodes/density.h"
#include "tests/bench/engine_run.h"
#include "tests/support/cases.h"
#include "tests/support/documents.h"

namespace remeshd::bench {
namespace {

/// Of the case if the subject is one, else by the CAD kernel.
double exact_volume(const Subject& subject, const CellularModel& cells) {
  for (const test::EditCase& c : test::seven_cases())
    if (c.edit == subject.name) return c.modified_volume;
  return cells.volume;
}

std::string store(const std::filesystem::path& folder, const std::string& name,
                  const ModelSource& model) {
  const std::filesystem::path file = folder / (name + ".json");
  std::ofstream out(file);
  out << test::write_model(model).dump(1) << "\n";
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
  return file.string();
}

}  // namespace

Subject case_subject(const std::string& name) {
  for (const test::EditCase& c : test::seven_cases())
    if (c.edit == name) {
      const ModelSource original = test::case_model(c.original);
      return {name, original, apply(original, test::case_edit(name))};
    }
  const std::vector<std::string>& parts = test::detailed_parts();
  if (std::ranges::find(parts, name) == parts.end())
    throw std::runtime_error("there is no case " + name);
  const ModelSource original = test::case_model("detailed/" + name);
  return {name, original, apply(original, test::case_edit("detailed/" + name))};
}

Group measure_group(const Subject& subject, std::uint32_t nodes, const Settings& settings) {
  std::filesystem::create_directories(settings.folder);
  EngineRun run{.original = store(settings.folder, subject.name + "-original", subject.original),
                .modified = store(settings.folder, subject.name + "-modified", subject.modified),
                .nodes = nodes,
                .sized = settings.sized};
  std::optional<PeerSession> peers;
  std::optional<CellularModel> cells;
  if (!settings.peers.empty()) {
    cells = build_cells(evaluate(subject.modified), Run{});
    peers.emplace(settings.folder, subject.name, run.modified, exact_volume(subject, *cells),
                  settings.sized, settings.limit_seconds);
    if (peers->faces() != cells->boundary.faces.size())
      std::cerr << subject.name << ": the peers' geometry has " << peers->faces()
                << " faces, the model " << cells->boundary.faces.size() << "\n";
  }

  Group group{.name = subject.name, .nodes = nodes, .series = {}};
  const auto keep = [&](const std::string& name, const Sample& sample) {
    group.series[name].push_back(sample);
    std::cerr << subject.name << " " << nodes << " " << name << ": "
              << (sample.failure.empty() ? std::to_string(sample.cpu) + " s" : sample.failure)
              << "\n";
  };
  std::uint32_t peer_nodes = 0;  // the same in every round, so that their sizes stay
  for (int round = 0; round < settings.repeats; ++round) {
    run.seed = settings.seeds[round % settings.seeds.size()];
    for (const std::uint32_t iterations : settings.iterations) {
      const auto measure_as = [&](RunKind kind, std::uint32_t count, const char* name,
                                  const Switches& switches = {}) {
        run.kind = kind;
        run.nodes = count;
        run.iterations = iterations;
        run.switches = switches;
        const Samples samples = measure(run, settings.limit_seconds);
        if (kind == RunKind::Remesh) keep(series_name("first", iterations), samples.at("first"));
        const Sample& sample = samples.at(kind == RunKind::Remesh ? "remesh" : "regular");
        keep(series_name(name, iterations), sample);
        return sample.nodes;
      };
      const std::uint32_t made = measure_as(RunKind::Remesh, nodes, "remesh");
      const std::uint32_t same = made > 0 ? made : nodes;
      measure_as(RunKind::Regular, same, "regular");
      if (settings.paper_regular && iterations > 0)
        measure_as(RunKind::Regular, same, "paper", {.paper = true});
      if (peer_nodes == 0) peer_nodes = same;
    }
    if (settings.chain > 0) {
      run.kind = RunKind::Chain;
      run.nodes = nodes;
      run.iterations = 10;
      run.switches = {};
      run.length = settings.chain;
      for (const auto& [name, sample] : measure(run, settings.limit_seconds)) keep(name, sample);
    }
    for (const Peer& peer : settings.peers) {
      if (peer_nodes == 0) peer_nodes = nodes;
      if (nodes > peer.most_nodes) continue;
      keep(peer.name,
           peers->run(peer, peer_nodes, edge_length_for(cells->volume, cells->area, peer_nodes)));
    }
  }
  return group;
}

}  // namespace remeshd::bench
