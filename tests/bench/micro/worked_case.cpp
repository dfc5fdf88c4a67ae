#include "tests/bench/micro/worked_case.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/optimise/optimise.h"
#include "engine/plan/copy_plan.h"
#include "engine/remesh/steps.h"
#include "tests/support/cases.h"

namespace remeshd::bench {
namespace {

WorkedCase work() {
  constexpr std::uint32_t kIterations = 5;
  constexpr std::uint64_t kSeed = 1;
  const MeshOptions options{.nodes = 15'000};
  const Run run;
  WorkedCase w;
  w.model = test::case_features("tool1-a");
  w.cells = build_cells(w.model, run);
  w.membership = std::make_unique<const Membership>(w.model);
  const Density density = resolve_density(Revision::none(), options, w.cells, run);
  w.edge_length = density.edge_length;
  const CopyPlan source(nullptr, w.model, w.edge_length, run);
  PatchNodes local = *initial_nodes(nullptr, source, density, options.start, kSeed, {}, run);
  w.samples = sample_boundary(w.cells.boundary, *w.membership, w.edge_length, kSeed, {}, run);
  w.all_samples.resize(w.samples.points.size());
  std::iota(w.all_samples.begin(), w.all_samples.end(), 0);
  const InsideTest inside = [&](const Vec3& p) { return w.membership->inside(p); };
  StartMesh start = start_mesh(local, source, w.cells.boundary.bounds, run);
  w.nodes = std::move(local.nodes);
  OptimiseResult loop = optimise(w.nodes, std::move(start), w.cells.boundary, inside, w.samples,
                                 {.edge_length = w.edge_length, .iterations = kIterations}, run);
  std::ranges::fill(w.nodes.free, 1);
  loop.mesh.for_each_tet([&](const Tet& tet) { w.delaunay.push_back(tet); });
  Candidate candidate =
      extract(w.nodes, std::move(loop), local.patch, source, w.cells, inside, run);
  w.mesh_nodes = std::move(candidate.nodes);
  w.peeled = std::move(candidate.delaunay.tets);
  return w;
}

}  // namespace

const WorkedCase& worked_case() {
  static const WorkedCase made = work();
  return made;
}

}  // namespace remeshd::bench
