// The stages of a regular run one by one, on tool1-a with 15,000 nodes:
//   remesh-microbench [--benchmark_filter=Delaunay] [--benchmark_repetitions=5]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <numeric>

#include "engine/base/random.h"
#include "engine/delaunay/delaunay_mesh.h"
#include "engine/improve/improve.h"
#include "engine/nodes/nearest.h"
#include "engine/optimise/pull.h"
#include "engine/optimise/relocate.h"
#include "tests/bench/micro/worked_case.h"

namespace {

using namespace remeshd;
using bench::worked_case;

std::vector<std::int32_t> all_of(const NodeSet& nodes) {
  std::vector<std::int32_t> all(nodes.positions.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

DelaunayMesh delaunay_of(const NodeSet& nodes) {
  Box box;
  for (const Vec3& p : nodes.positions) box.add(p);
  DelaunayMesh mesh(box);
  mesh.insert(nodes.positions, all_of(nodes), Run{});
  return mesh;
}

/// Items are nodes.
void delaunay_insertion(benchmark::State& state) {
  const NodeSet& nodes = worked_case().nodes;
  while (state.KeepRunning()) benchmark::DoNotOptimize(delaunay_of(nodes).size());
  state.SetItemsProcessed(state.iterations() * nodes.size());
}
BENCHMARK(delaunay_insertion)->Unit(benchmark::kMillisecond);

/// Interior nodes to and fro by a share of the edge length, in per mille: by flips, as late
/// iterations of the loop do. Items are nodes moved.
void delaunay_move(benchmark::State& state) {
  const bench::WorkedCase& w = worked_case();
  const double step = 1e-3 * static_cast<double>(state.range(0)) * w.edge_length;
  std::vector<std::int32_t> moving;
  std::vector<Vec3> there = w.nodes.positions;
  Random random(1);
  for (std::int32_t n = 0; n < w.nodes.size(); ++n) {
    if (w.nodes.supports[n].kind != Support::Kind::Interior) continue;
    moving.push_back(n);
    there[n] +=
        Vec3{random.uniform(-step, step), random.uniform(-step, step), random.uniform(-step, step)};
  }
  DelaunayMesh mesh = delaunay_of(w.nodes);
  bool out = true;
  while (state.KeepRunning()) {
    if (mesh.move(out ? there : w.nodes.positions, moving, Run{}) != DelaunayMesh::Moved::Done) {
      state.SkipWithError("too far for flips");
      break;
    }
    out = !out;
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(moving.size()));
}
BENCHMARK(delaunay_move)->Arg(10)->Arg(30)->Unit(benchmark::kMillisecond);

void nearest_node_grid(benchmark::State& state) {
  const bench::WorkedCase& w = worked_case();
  while (state.KeepRunning())
    benchmark::DoNotOptimize(NearestNode(w.nodes.positions, w.edge_length).nearest({}));
  state.SetItemsProcessed(state.iterations() * w.nodes.size());
}
BENCHMARK(nearest_node_grid)->Unit(benchmark::kMillisecond);

/// Items are samples of the boundary, each asking for its node.
void nearest_node_query(benchmark::State& state) {
  const bench::WorkedCase& w = worked_case();
  const NearestNode grid(w.nodes.positions, w.edge_length);
  while (state.KeepRunning())
    for (const Sample& sample : w.samples.points)
      benchmark::DoNotOptimize(grid.nearest(sample.position));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(w.samples.points.size()));
}
BENCHMARK(nearest_node_query)->Unit(benchmark::kMillisecond);

/// One interior pass of the loop.
void interior_pass(benchmark::State& state) {
  const bench::WorkedCase& w = worked_case();
  const InsideTest inside = [&](const Vec3& p) { return w.membership->inside(p); };
  NodeSet nodes = w.nodes;
  while (state.KeepRunning()) {
    nodes.positions = w.nodes.positions;
    relocate(nodes, w.delaunay, inside, NodeLengths(w.edge_length), Run{});
    benchmark::DoNotOptimize(nodes.positions.data());
  }
  state.SetItemsProcessed(state.iterations() * nodes.size());
}
BENCHMARK(interior_pass)->Unit(benchmark::kMillisecond);

/// One boundary pass of the loop with all samples; without splits, so that every pass finds the
/// same. Items are samples.
void boundary_pass(benchmark::State& state) {
  const bench::WorkedCase& w = worked_case();
  const Adjacency adjacency(w.cells.boundary);
  const PullOptions options{.sizes = w.edge_length, .split = false};
  while (state.KeepRunning()) {
    NodeSet nodes = w.nodes;
    NearestToPoints nearest(w.samples.positions(), 0.8 * w.edge_length);
    benchmark::DoNotOptimize(pull_boundary(nodes, w.cells.boundary, adjacency, w.samples,
                                           w.all_samples, nearest, options, Run{}));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(w.samples.points.size()));
}
BENCHMARK(boundary_pass)->Unit(benchmark::kMillisecond);

/// Items are tets of the peeled mesh.
void clean_up(benchmark::State& state) {
  const bench::WorkedCase& w = worked_case();
  const TetMesh mesh{w.mesh_nodes.positions, w.peeled};
  const std::vector<std::uint8_t> dirty(mesh.tets.size(), 1);
  while (state.KeepRunning())
    benchmark::DoNotOptimize(
        improve(mesh, w.mesh_nodes.supports, w.cells.boundary, dirty, {}, Run{}).below_threshold);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.tets.size()));
}
BENCHMARK(clean_up)->Unit(benchmark::kMillisecond);

/// Items are points: the tets' centroids.
void membership(benchmark::State& state) {
  const bench::WorkedCase& w = worked_case();
  std::vector<Vec3> points;
  for (const Tet& t : w.delaunay)
    points.push_back(0.25 * (w.nodes.positions[t[0]] + w.nodes.positions[t[1]] +
                             w.nodes.positions[t[2]] + w.nodes.positions[t[3]]));
  while (state.KeepRunning())
    benchmark::DoNotOptimize(
        std::ranges::count_if(points, [&](const Vec3& p) { return w.membership->inside(p); }));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
BENCHMARK(membership)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
