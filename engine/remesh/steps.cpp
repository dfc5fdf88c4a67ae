#include "engine/remesh/steps.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/hilbert.h"
#include "engine/base/tolerance.h"
#include "engine/boundary/control_mesh.h"
#include "engine/nodes/active_faces.h"
#include "engine/nodes/copy_nodes.h"
#include "engine/nodes/decimate_close_nodes.h"
#include "engine/nodes/density.h"
#include "engine/nodes/dump.h"
#include "engine/nodes/fill/fill.h"
#include "engine/nodes/place_supports.h"
#include "engine/optimise/large_circumballs.h"
#include "engine/optimise/live_mesh.h"
#include "engine/remesh/finish/insert_nodes.h"
#include "engine/remesh/node_limit.h"
#include "engine/revision/delaunay_state.h"

namespace remeshd {
namespace {

constexpr double kRounding = 1 + 1e-9;  // x a margin, lest rounding leaves something out
constexpr double kNearChange = 2;       // x edge length: further from the changed boxes nodes stay
// x edge length: no node is further than this from its position in the Delaunay mesh.
constexpr double kMostFollowed = 0.1;
constexpr double kSampledBeyond = 0.5;   // x edge length: from a node to samples it is nearest to
constexpr double kMostRefined = 4;       // x nodes of an even mesh: most new ones of a refined one
constexpr int kSampledSteps = 4;         // cubes of a Region along the reach
constexpr double kThin = 2;              // x edge length: mean thickness of a thin part
constexpr double kSizedThin = 3.25;      // the same, where edge lengths differ
constexpr double kSamplesToNodes = 5.4;  // samples on an edge length^2 / nodes in an edge length^3

/// Nodes of the parent that perhaps cannot stay as they are: those in the changed boxes or within
/// two edge lengths of them. `everything`: all nodes.
std::vector<std::int32_t> candidate_nodes(const CowVector<Vec3>& positions, const CopyPlan& plan,
                                          const SizeField& sizes, bool everything) {
  std::vector<std::int32_t> nodes;
  const auto is_near = [&](const Vec3& p) {
    return plan.in_changed(p, kNearChange * sizes.base()) &&
           (sizes.even() || plan.in_changed(p, kNearChange * sizes(p)));
  };
  for (std::size_t n = 0; n < positions.size(); ++n)
    if (everything || is_near(positions[n])) nodes.push_back(static_cast<std::int32_t>(n));
  return nodes;
}

/// The parent's tets in the model that have one of the nodes. `meets(box)`: false only for a box
/// that no such tet lies in.
template <class Meets>
std::vector<Tet> tets_at(const DelaunayState& delaunay_state, std::span<const std::int32_t> nodes,
                         const Meets& meets) {
  std::vector<std::uint8_t> wanted(delaunay_state.positions().size(), 0);
  for (const std::int32_t n : nodes) wanted[n] = 1;
  std::vector<Tet> tets;
  delaunay_state.mesh.for_each_slot_near(meets, [&](std::int32_t s) {
    if (!delaunay_state.inside(s)) return;
    const Tet t = delaunay_state.mesh.corners(s);
    if (wanted[t[0]] || wanted[t[1]] || wanted[t[2]] || wanted[t[3]]) tets.push_back(t);
  });
  return tets;
}

/// Where an edit needs samples of the boundary: round its free nodes, as far out as fixed ones may
/// be freed by the loop, and near fixed nodes that have to find what they stand on.
std::vector<Region> sampled_places(const PatchNodes& local, double edge_length, double reach) {
  const NodeSet& nodes = local.nodes;
  std::vector<Vec3> free, to_place;
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    if (nodes.is_free(n))
      free.push_back(nodes.positions[n]);
    else if (n >= local.placed && nodes.supports[n].kind != Support::Kind::Interior)
      to_place.push_back(nodes.positions[n]);
  }
  return {Region(free, reach + kSampledBeyond * edge_length, kSampledSteps),
          Region(to_place, kSupportReach * edge_length, 1)};
}

/// The inside test that the options ask for. It keeps a reference to `membership`.
InsideTest inside_test(MeshOptions::Inside kind, const Membership& membership,
                       const BoundaryModel& boundary, const Run& run) {
  if (kind == MeshOptions::Inside::Membership)
    return [&membership](const Vec3& p) { return membership.inside(p); };
  const auto mesh = std::make_shared<const ControlMesh>(ControlMesh::build(boundary, run));
  return [mesh](const Vec3& p) { return mesh->inside(p); };
}

/// The Delaunay mesh of the fixed nodes, made from the patch's by removing all others; an empty one
/// where that cannot be done and the patch is the whole mesh. Throws PatchTooSmall.
StartMesh start_mesh(const PatchNodes& local, const CopyPlan& plan, const Box& bounds,
                     const Run& run) {
  const NodeSet& nodes = local.nodes;
  const MeshPatch& patch = local.patch;
  StartMesh start{DelaunayMesh(bounds), std::vector<std::uint8_t>(nodes.positions.size(), 0)};
  const auto without = [&] {
    if (patch.mesh.emptied().patch_too_small()) throw PatchTooSmall{"taking out the free nodes"};
    return start;
  };
  if (!patch.mesh.encloses(bounds)) return without();
  std::vector<std::int32_t> name(patch.nodes.size(), -1);
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (nodes.original[n] >= 0 && !nodes.is_free(n) &&
        plan.transforms()[nodes.transform[n]].is_identity())
      name[nodes.original[n]] = n;
  std::vector<std::int32_t> others;
  for (std::size_t o = 0; o < name.size(); ++o)
    if (name[o] < 0) others.push_back(static_cast<std::int32_t>(o));
  DelaunayMesh mesh = patch.mesh;
  if (!mesh.remove(others, run)) return without();
  mesh.rename(name, nodes.size());
  // What moves as one body brings its tets along.
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(plan.transforms().size()); ++t) {
    if (plan.transforms()[t].is_identity()) continue;
    std::vector<std::int32_t> moved(patch.nodes.size(), -1);
    for (std::int32_t n = 0; n < nodes.size(); ++n)
      if (nodes.transform[n] == t && !nodes.is_free(n) && !patch.followed[nodes.original[n]])
        moved[nodes.original[n]] = n;
    mesh.insert_moved(patch.mesh, moved, nodes.positions, run);
    for (const std::int32_t n : moved)
      if (n >= 0) start.holds[n] = 1;
  }
  if (mesh.patch_too_small()) throw PatchTooSmall{"moving nodes"};
  for (const std::int32_t n : name)
    if (n >= 0) start.holds[n] = 1;
  start.mesh = std::move(mesh);
  return start;
}

/// Whether walls of one to two edge lengths are much of what is meshed, estimated from its mean
/// thickness. Not in an even mesh, nor in a thick part whose size field is even: both are meshed
/// alike.
bool has_thin_walls(const MeshingTask& task, const NodeSet& nodes, const Samples& samples) {
  const CellularModel& cells = task.cells;
  const SizeField& sizes = task.density.sizes;
  if (task.options.sizing.even) return false;
  if (sizes.even()) return 2 * cells.volume / cells.area < kThin * sizes.base();
  return 2 * kSamplesToNodes * nodes.size() < kSizedThin * static_cast<double>(samples.edges_begin);
}

double mean_free_share(const OptimiseResult& loop, std::int32_t nodes) {
  if (loop.free_per_iteration.empty() || nodes == 0) return 0;
  double sum = 0;
  for (const std::uint32_t f : loop.free_per_iteration) sum += f;
  return std::fmin(1.0, sum / static_cast<double>(loop.free_per_iteration.size()) / nodes);
}

/// The density for a mesh of new nodes alone: they are counted for the whole model, unless the
/// options ask for an edge length.
Density counted(Density density, const Revision& modified) {
  density.inherited = false;
  if (!modified.options.size)
    density.count = std::lround(density.nodes_per_volume * modified.cells.volume);
  return density;
}

/// The new nodes, in the material that the plan says is new (Sects. 3.2, 7).
std::vector<Vec3> new_nodes(const MeshingTask& task) {
  const CopyPlan& plan = task.plan;
  const Density& density = task.density;
  const auto is_new = [&](const Vec3& p) { return plan(p) == CopyPlan::kNew; };
  if (density.start && task.seed == task.options.seed && task.refined_at.empty())
    return *density.start;
  if (!density.sizes.even()) {
    const Box bounds = grown(task.cells.boundary.bounds, density.sizes.base());
    std::vector<Vec3> nodes =
        fill_graded(plan.changed_within(bounds), is_new, density.sizes, task.seed, task.run);
    if (task.refined_at.empty()) check_new_nodes(nodes.size(), task.options, task.run);
    return nodes;
  }
  const auto fill = task.options.start == MeshOptions::Start::Lattice ? fill_lattice : fill_random;
  return fill(plan.changed(), is_new,
              {.edge_length = density.sizes.base(),
               .density = density.nodes_per_volume,
               .count = density.count,
               .seed = task.seed},
              task.run);
}

/// Where the last attempt's mesh was wrong, and the places that it was refined at because earlier
/// meshes were wrong there.
std::vector<Vec3> wrong_so_far(const Attempt& failed) {
  std::vector<Vec3> places = failed.refined_at;
  const std::vector<Vec3> more = failed.faulty_places();
  places.insert(places.end(), more.begin(), more.end());
  return places;
}

/// How many new nodes a mesh that is refined where it was wrong may begin with, at most.
std::size_t most_refined(const MeshingTask& task) {
  const CellularModel& cells = task.cells;
  return static_cast<std::size_t>(
      kMostRefined * expected_nodes(cells.volume, cells.area, task.density.sizes.base()));
}

/// A plan of the strategy's own: for a mesh of new nodes alone, or the problem's with what was
/// wrong made anew. Null where the strategy goes by the problem's plan.
std::unique_ptr<const CopyPlan> own_plan(const Strategy& how, const Problem& problem,
                                         const Attempt* failed) {
  if (how.reuse == Reuse::Nothing) return plan_of_nothing(problem);
  if (how.refined == 0) return nullptr;
  return std::make_unique<const CopyPlan>(
      problem.plan().with_new_in(region_of(wrong_so_far(*failed), problem.density.sizes)));
}

/// The run with a folder for dumps of the strategy's own, named after its row in the table.
Run with_folder(Run run, const Strategy& how) {
  if (run.dumps.empty()) return run;
  const std::span<const Strategy> all = strategies();
  const auto at = std::ranges::find(all, std::string_view(how.name),
                                    [](const Strategy& s) { return std::string_view(s.name); });
  std::string folder = std::to_string(at - all.begin() + 1) + "-" + how.name;
  std::erase(folder, ',');
  std::ranges::replace(folder, ' ', '-');
  run.dumps /= folder;
  return run;
}

}  // namespace

MeshingTask::MeshingTask(const Strategy& how, const Problem& problem, const Attempt* failed)
    : own_plan_(own_plan(how, problem, failed)),
      parent(how.reuse == Reuse::Nothing ? Revision::none() : problem.parent),
      plan(own_plan_ ? *own_plan_ : problem.plan()),
      cells(problem.modified.cells),
      options(problem.modified.options),
      density(how.reuse == Reuse::Nothing ? counted(problem.density, problem.modified)
                                          : problem.density),
      seed(options.seed + how.other_seed),
      all_free(how.reuse == Reuse::FreedNodes),
      reach(how.reach * density.sizes.base()),
      entities(std::isfinite(reach) ? &problem.entities() : nullptr),
      run(with_folder(problem.run, how)) {
  if (how.refined == 0) return;
  refined_at = wrong_so_far(*failed);
  density.sizes = density.sizes.refined(refined_at, how.refined, cells.boundary.bounds);
}

std::optional<PatchNodes> copy_and_fill(const MeshingTask& task, Attempt& attempt) {
  Stopwatch watch;
  const Revision& parent = task.parent;
  const CopyPlan& plan = task.plan;
  const Run& run = task.run;
  const SizeField& sizes = task.density.sizes;
  run.report("nodes", 0.1);
  dump_text(run, "04-plan", [&] { return to_text(plan, parent.model); });
  const CopiedMesh original = copied_mesh(parent);
  const double margin = (kNearChange + kMostFollowed) * sizes.base();
  const bool everything = std::isinf(task.reach);
  const std::vector<std::int32_t> candidates =
      candidate_nodes(original.positions, plan, sizes, everything);
  const std::vector<Tet> tets = tets_at(original.delaunay_state, candidates, [&](const Box& box) {
    return everything || plan.meets_changed(grown(box, kRounding * margin));
  });
  CopiedNodes near = copy_nodes(plan, {original.positions, original.supports, candidates, tets},
                                sizes_of(parent, run), run);
  // What is near in space is to be near in memory: revisions share pages.
  const std::vector<Vec3> fill = new_nodes(task);
  if (!task.refined_at.empty() && fill.size() > most_refined(task)) {
    attempt.serves = false;
    attempt.reason = "it would take " + std::to_string(fill.size()) + " new nodes";
    return std::nullopt;
  }
  for (const Vec3& p : along_hilbert_curve(fill)) near.add_new(p);
  if (plan.copies()) {  // new nodes alone are free, and spread evenly
    free_at_active_faces(near, plan, sizes, run);
    decimate_close_nodes(near, sizes);
  }
  std::optional<PatchNodes> local =
      extract_patch(near, candidates, original, task.entities, plan, task.reach);
  if (!local) {
    attempt.reason = "a node of the base stands on nothing that the boundary still has";
    return local;
  }
  NodeSet& nodes = local->nodes;
  dump_nodes(run, "05-nodes", nodes, task.density.sizes);
  if (task.all_free) std::ranges::fill(nodes.state, NodeState::Free);
  Counts& counts = attempt.counts;
  counts.nodes_new =
      static_cast<std::uint32_t>(std::count(nodes.original.begin(), nodes.original.end(), -1));
  counts.nodes_copied =
      static_cast<std::uint32_t>(nodes.size() + nodes.elsewhere) - counts.nodes_new;
  watch.lap(attempt.seconds.copy);
  return local;
}

SampledBoundary sample(const MeshingTask& task, PatchNodes& local, Attempt& attempt) {
  Stopwatch watch;
  const BoundaryModel& boundary = task.cells.boundary;
  const Membership& membership = task.plan.modified();
  const SizeField& sizes = task.density.sizes;
  SampleOptions sampling;
  if (std::isfinite(task.reach)) sampling.where = sampled_places(local, sizes.base(), task.reach);
  SampledBoundary sampled{
      sample_boundary(boundary, membership, sizes, task.seed, sampling, task.run),
      inside_test(task.options.inside, membership, boundary, task.run)};
  place_supports(local.nodes, boundary, sampled.samples, sizes,
                 tolerance::kOnSurface * boundary.bounds.diagonal(), local.placed, task.run);
  attempt.counts.samples = static_cast<std::uint32_t>(sampled.samples.points.size());
  attempt.counts.free_at_start = local.nodes.count(NodeState::Free);
  watch.lap(attempt.seconds.setup);
  return sampled;
}

namespace {

/// Circumradius above which a tet stands in a void, x edge length. None does where the density is
/// not the parent's: between nodes of two densities tets are large too.
double largest_ball(const MeshingTask& task) {
  if (task.all_free || !task.density.inherited) return HUGE_VAL;
  const bool even = task.options.sizing.even || task.density.sizes.even();
  return even ? kLargestBallEven : kLargestBallSized;
}

}  // namespace

OptimiseResult optimise(const MeshingTask& task, PatchNodes& local, const SampledBoundary& sampled,
                        Attempt& attempt) {
  Stopwatch watch;
  const BoundaryModel& boundary = task.cells.boundary;
  NodeSet& nodes = local.nodes;
  const bool all_free = nodes.elsewhere == 0 && nodes.count(NodeState::Fixed) == 0;
  OptimiseResult loop = optimise(nodes, start_mesh(local, task.plan, boundary.bounds, task.run),
                                 boundary, sampled.inside, sampled.samples,
                                 {.sizes = task.density.sizes,
                                  .iterations = task.options.iterations,
                                  .largest_ball = largest_ball(task),
                                  .thin_walls = has_thin_walls(task, nodes, sampled.samples),
                                  .rebuild = task.options.rebuild},
                                 task.run);
  insert_in_segments(nodes, loop.mesh, nodes.size(), boundary,
                     {.sizes = task.density.sizes,
                      .wanted = loop.active_edges,
                      .fewest_links = task.density.fewest_links,
                      .make_room = !task.options.sizing.even},
                     task.run);
  Counts& counts = attempt.counts;
  counts.free_at_end = nodes.count(NodeState::Free);
  counts.free_per_iteration = loop.free_per_iteration;
  counts.iterations = static_cast<std::uint32_t>(loop.free_per_iteration.size());
  counts.active_samples = loop.samples_active;
  // Nodes added on the way are free from their first iteration on.
  attempt.free_share = all_free ? 1 : mean_free_share(loop, nodes.size() + nodes.elsewhere);
  watch.lap(attempt.seconds.optimise);
  return loop;
}

}  // namespace remeshd
