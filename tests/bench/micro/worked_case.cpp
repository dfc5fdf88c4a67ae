#include "tests/bench/micro/worked_case.h"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

#include "engine/remesh/steps.h"
#include "tests/support/cases.h"

namespace remeshd::bench {
namespace {

/// The strategy of a first mesh.
const Strategy& first_mesh() {
  return *std::ranges::find(strategies(), std::string_view("local, everywhere"),
                            [](const Strategy& s) { return std::string_view(s.name); });
}

WorkedCase work() {
  const Run run;
  Revision made;
  made.options = {.nodes = 15'000, .iterations = 5};
  WorkedCase w;
  w.model = made.model = test::case_features("tool1-a");
  w.cells = made.cells = build_cells(w.model, run);
  w.membership = std::make_unique<const Membership>(w.model);
  const Density density = resolve_density(Revision::none(), made.options, made.model, w.cells, run);
  w.edge_length = density.sizes.base();
  const Problem problem(Revision::none(), made, density, run);
  const MeshingTask task(first_mesh(), problem, nullptr);
  Attempt attempt("local");
  PatchNodes nodes = *copy_and_fill(task, attempt);
  SampledBoundary boundary = sample(task, nodes, attempt);
  OptimiseResult loop = optimise(task, nodes, boundary, attempt);
  w.nodes = nodes.nodes;
  std::ranges::fill(w.nodes.state, NodeState::Free);
  loop.mesh.for_each_tet([&](const Tet& tet) { w.delaunay.push_back(tet); });
  Candidate mesh = extract_verified(task, std::move(nodes), std::move(loop), boundary, attempt);
  w.mesh_nodes = std::move(mesh.nodes);
  w.peeled = std::move(mesh.delaunay.tets);
  w.samples = std::move(boundary.samples);
  w.all_samples.resize(w.samples.points.size());
  std::iota(w.all_samples.begin(), w.all_samples.end(), 0);
  return w;
}

}  // namespace

const WorkedCase& worked_case() {
  static const WorkedCase made = work();
  return made;
}

}  // namespace remeshd::bench
