// From the optimised nodes to a verified mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <variant>

#include "engine/extract/peel.h"
#include "engine/improve/improve.h"
#include "engine/nodes/dump.h"
#include "engine/optimise/live_mesh.h"
#include "engine/patch/node_map.h"
#include "engine/patch/reuse_improved_tets.h"
#include "engine/patch/stitch.h"
#include "engine/remesh/last_resort/refill.h"
#include "engine/remesh/repair.h"
#include "engine/remesh/steps.h"
#include "engine/sizing/size_rules.h"

namespace remeshd {
namespace {

struct Repairs {
  int rounds = 8;
  double fewer = 0.7;  ///< of the faults before a round, for the next to be made
  double few_inserted = 200, most_inserted = 0.2;
  std::uint32_t all_failures = 100'000;
  double hopeless =
      0.1;  ///< of a refill's tets: with so many faults no clean-up or other try helps
};
constexpr Repairs kRepairs;
constexpr std::array kRefillMargins{1.5, 1.5, 3.0, 3.0, 6.0};  // x edge length

/// Leaves out the nodes that no tet uses, but for those at the interface, and renumbers the tets
/// and the Delaunay mesh. Returns the numbers, by node; -1 for those left out.
std::vector<std::int32_t> drop_unused(NodeSet& nodes, std::vector<Tet>& tets, DelaunayMesh& mesh,
                                      const Run& run) {
  std::vector<std::int32_t> number(nodes.positions.size(), -1);
  std::fill_n(number.begin(), nodes.interface_nodes, 0);
  for (const Tet& t : tets)
    for (const std::int32_t n : t) number[n] = 0;
  std::vector<std::int32_t> unused;
  std::int32_t next = 0;
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    if (number[n] < 0) {
      unused.push_back(n);
      continue;
    }
    nodes.move(n, next);
    number[n] = next++;
  }
  if (unused.empty()) return number;
  nodes.resize(next);
  for (Tet& t : tets) t = renamed(t, number);
  if (mesh.remove(unused, run)) {
    mesh.rename(number, next);
  } else {
    mesh = mesh.emptied();
    std::vector<std::int32_t> all(next);
    std::iota(all.begin(), all.end(), 0);
    mesh.insert(nodes.positions, all, run);
  }
  if (mesh.patch_too_small()) throw PatchTooSmall{"leaving out nodes"};
  return number;
}

/// What is known of the patch's tets and their neighbours beyond it, from before: of those that are
/// as they were and meet no changed box.
KnownClassification known_classification(const NodeSet& nodes, const DelaunayMesh& mesh,
                                         const MeshPatch& patch, const CopyPlan& plan) {
  KnownClassification known = KnownClassification::nothing(mesh, patch.exterior);
  // A mesh that began anew has other slots, and may have fewer.
  const auto slots = static_cast<std::int32_t>(std::min(patch.mesh.slots(), mesh.slots()));
  for (std::int32_t s = 0; s < slots; ++s) {
    if (!mesh.in_use(s)) continue;
    const Tet then = patch.mesh.corners(s), now = mesh.corners(s);
    const bool same = std::ranges::equal(then, now, [&](std::int32_t a, std::int32_t b) {
      if (a < 0 || b < 0) return a == b;  // super vertices
      return a == nodes.original[b] && nodes.positions[b] == patch.positions[a];
    });
    if (same && !plan.meets_changed(now, nodes.positions))
      known.tets[s] = patch.inside[s] ? KnownClassification::Known::Inside
                                      : KnownClassification::Known::Outside;
  }
  return known;
}

/// Supports of the nodes that are not in the patch; of the others any.
CowVector<Support> supports_left(const Revision& parent, const MeshPatch& cut,
                                 const EntityMap* entities) {
  const CowVector<Support>& then = parent.supports();
  const CowVector<Vec3>& positions = parent.delaunay_state->positions();
  if (entities == nullptr) return CowVector<Support>(then.size(), {});
  CowVector<Support> supports = then;
  const std::vector<std::int32_t>& patch = cut.nodes;  // ascending
  auto next = patch.begin();
  then.for_each([&](std::size_t n, const Support& was) {
    if (was.kind == Support::Kind::Interior) return;
    next = std::find_if(next, patch.end(),
                        [&](std::int32_t p) { return p >= static_cast<std::int32_t>(n); });
    if (next != patch.end() && *next == static_cast<std::int32_t>(n)) return;
    const std::optional<Support> support = (*entities)(was, positions[n]);
    if (!support) throw PatchTooSmall{"naming where nodes stand"};
    supports.set(n, *support);
  });
  return supports;
}

/// The Delaunay mesh's tets in the model.
PeeledMesh peeled(const Candidate& c, const MeshingTask& task, const MeshPatch& patch,
                  const InsideTest& inside) {
  return peel(c.nodes, c.loop.mesh, task.cells.boundary, inside,
              known_classification(c.nodes, c.loop.mesh, patch, task.plan),
              {.edges_too = !task.options.sizing.even || !task.density.sizes.even()}, task.run);
}

/// The peeled Delaunay mesh of optimised nodes; nodes in no tet are left out. Throws PatchTooSmall.
Candidate extract(NodeSet nodes, OptimiseResult loop, const MeshingTask& task,
                  const MeshPatch& patch, const InsideTest& inside) {
  Candidate c;
  c.loop = std::move(loop);
  c.nodes = std::move(nodes);
  task.run.report("extract", 0.8);
  c.delaunay = peeled(c, task, patch, inside);
  drop_unused(c.nodes, c.delaunay.tets, c.loop.mesh, task.run);
  dump_nodes(task.run, "08-peel", c.nodes, task.density.sizes, c.delaunay.tets);
  return c;
}

/// The patch's mesh as it comes from the loop, all of it to be cleaned up.
ReusedMesh all_new(const Candidate& c) {
  const std::vector<Tet>& tets = c.delaunay.tets;
  return {{c.nodes.positions, tets}, std::vector<std::uint8_t>(tets.size(), 1), {}};
}

std::vector<std::int32_t> looked_up(std::span<const std::int32_t> values,
                                    std::span<const std::int32_t> at) {
  std::vector<std::int32_t> result(at.size(), -1);
  for (std::size_t k = 0; k < at.size(); ++k)
    if (at[k] >= 0) result[k] = values[at[k]];
  return result;
}

/// The patch's mesh: improved tets reused where nothing changed, the rest cleaned up.
ReusedMesh cleaned_up(Candidate& c, const MeshingTask& task, const MeshPatch& patch,
                      bool clean_up) {
  const MeshOptions& options = task.options;
  ReusedMesh reused = options.clean_up ? reuse_improved_tets(c.nodes, c.delaunay, patch,
                                                             task.plan.transforms(), task.run)
                                       : all_new(c);
  task.run.report("improve", 0.85);
  c.bad_at_interface = 0;
  if (!clean_up) return reused;
  ImproveResult improved =
      improve(reused.mesh, c.nodes.supports, task.cells.boundary, reused.dirty,
              {.threshold = options.threshold, .locked = c.nodes.interface_nodes}, task.run);
  c.bad_at_interface = improved.bad_at_interface;
  return {
      std::move(improved.mesh),
      {},
      {looked_up(reused.same.peeled, improved.was), looked_up(reused.same.output, improved.was)}};
}

/// Puts a patch's mesh into the parent's and verifies the whole; `most_failures` as in
/// VerifyOptions. Throws PatchTooSmall.
void put_back(Candidate& c, const ReusedMesh& mesh, const MeshingTask& task, const MeshPatch& patch,
              std::uint32_t most_failures = VerifyOptions{}.most_failures) {
  const CellularModel& cells = task.cells;
  c.whole = {};  // its memory, where it is made again
  const PatchMesh made{c.nodes, c.loop.mesh, c.delaunay, mesh.mesh, mesh.same};
  c.whole = stitch(task.parent, supports_left(task.parent, patch, task.entities), patch, made,
                   task.plan, task.run);
  task.run.report("verify", 0.95);
  const VerifiedParent parent =
      verified_parent(task.parent, c.whole.map.original_node, c.whole.map.original_tet);
  const VerifyOptions proof{
      .material = [&](const Vec3& p) { return task.plan.modified().inside(p); },
      .parent = &parent,
      .most_failures = most_failures};
  const Stopwatch watch;
  c.verification = verify(c.whole.mesh, c.whole.delaunay_state.supports, cells.boundary,
                          cells.volume, task.run, proof);
  c.verify_seconds += watch.total();
}

/// Reuse of improved tets, clean-up, stitching into the parent's mesh, map and verification of an
/// extracted mesh. `clean_up`: false for a draft, to see whether the boundary is all there. Throws
/// PatchTooSmall.
void finish(Candidate& c, const MeshingTask& task, const MeshPatch& patch, bool clean_up) {
  put_back(c, cleaned_up(c, task, patch, clean_up), task, patch);
}

/// Whether so much is wrong that other refills of this mesh are in vain: between walls that all but
/// coincide whatever fills the place is flat. `made`: tets of the refill.
bool is_hopeless(const Candidate& c, std::ptrdiff_t made) {
  return static_cast<double>(c.verification.failures.size()) >
         kRepairs.hopeless * static_cast<double>(made);
}

/// The mesh with a part of the patch refilled, its new nodes in the Delaunay mesh too, cleaned up
/// and verified. `made_anew`: of its tets, those that are new. Throws PatchTooSmall.
Candidate with_refilled(const Candidate& c, const ReusedMesh& mesh, RefilledMesh refilled,
                        const MeshingTask& task, const MeshPatch& patch, const InsideTest& inside,
                        std::ptrdiff_t& made_anew) {
  Candidate next;
  next.loop = c.loop;
  next.nodes = c.nodes;
  next.verify_seconds = c.verify_seconds;
  const std::int32_t first_new = c.nodes.size();
  for (std::size_t k = 0; k < refilled.supports.size(); ++k)
    next.nodes.add_new(refilled.mesh.nodes[first_new + k], refilled.supports[k]);
  std::vector<std::uint8_t> holds(next.nodes.positions.size(), 0);
  std::fill_n(holds.begin(), first_new, 1);
  LiveMesh live(c.loop.mesh, std::move(holds), false, task.run);
  live.follow(next.nodes);
  next.loop.mesh = live.mesh();
  const std::vector<std::int32_t> number =
      drop_unused(next.nodes, refilled.mesh.tets, next.loop.mesh, task.run);
  for (std::size_t n = 0; n < number.size(); ++n)
    if (number[n] >= 0) refilled.mesh.nodes[number[n]] = refilled.mesh.nodes[n];
  refilled.mesh.nodes.resize(next.nodes.positions.size());
  next.delaunay = peeled(next, task, patch, inside);

  ReusedMesh made{std::move(refilled.mesh), {}, {{}, looked_up(mesh.same.output, refilled.was)}};
  std::vector<std::int32_t> was = refilled.was;
  put_back(next, made, task, patch, kRepairs.all_failures);
  made_anew = std::ranges::count(was, -1);
  if (task.options.clean_up && !is_hopeless(next, made_anew) &&
      only_tets_are_wrong(next.verification) && can_be_improved(made.mesh, next.verification)) {
    const std::vector<std::uint8_t> dirty =
        worth_improving(made.mesh, refilled, mesh, next, task.cells.boundary,
                        least_size(task.options.sizing, task.density.sizes.base()));
    ImproveResult improved = improve(
        made.mesh, next.nodes.supports, task.cells.boundary, dirty,
        {.threshold = task.options.threshold, .locked = next.nodes.interface_nodes}, task.run);
    was = looked_up(refilled.was, improved.was);
    made = {std::move(improved.mesh), {}, {{}, looked_up(mesh.same.output, was)}};
    put_back(next, made, task, patch, kRepairs.all_failures);
    made_anew = std::ranges::count(was, -1);
  }
  return next;
}

/// The local last resort, where a mesh is not valid: what is wrong is refilled, with smaller facets
/// where it is wrong again, and more and more round it.
void confine(Candidate& c, const MeshingTask& task, const MeshPatch& patch,
             const InsideTest& inside, Attempt& attempt) {
  ReusedMesh mesh = cleaned_up(c, task, patch, false);  // clean-up mends nothing
  put_back(c, mesh, task, patch, kRepairs.all_failures);
  if (c.verification.valid) {  // it is what is wrong
    mesh = cleaned_up(c, task, patch, task.options.clean_up);
    put_back(c, mesh, task, patch, kRepairs.all_failures);
  }
  const std::vector<Vec3> places = faulty_places(c.verification);
  std::vector<Vec3> wrong_again;
  struct Tried {
    double margin = 0;
    std::size_t wrong_again = 0;
  } last;
  for (const double margin : kRefillMargins) {
    if (places.empty()) return;
    if (margin == last.margin && wrong_again.size() == last.wrong_again) continue;  // the same
    last = {margin, wrong_again.size()};
    const Stopwatch watch;
    const auto give_up = [&](const std::string& why) {
      attempt.tries.push_back({attempt.name + ", refilled", why, watch.total()});
    };
    auto made = refill({c.whole, c.verification, mesh.mesh, places, wrong_again},
                       task.cells.boundary, task.density.sizes, margin, task.run);
    if (const auto* why = std::get_if<std::string>(&made)) {
      give_up(*why);
      continue;
    }
    try {
      std::ptrdiff_t made_anew = 0;
      Candidate next = with_refilled(c, mesh, std::get<RefilledMesh>(std::move(made)), task, patch,
                                     inside, made_anew);
      if (next.verification.valid) {
        const MeshDefect& defect = c.verification.failures.front();
        attempt.warnings.push_back({.code = WarningCode::Fallback,
                                    .message = defect.what + "; TetGen filled the place",
                                    .point = defect.place});
        c = std::move(next);
        attempt.last_resort_share =
            static_cast<double>(made_anew) / static_cast<double>(c.whole.mesh.tets.size());
        return;
      }
      give_up(next.verification.failures.front().what);
      if (is_hopeless(next, made_anew)) {
        attempt.hopeless = true;
        return;
      }
      const std::vector<Vec3> more = faulty_places(next.verification);
      wrong_again.insert(wrong_again.end(), more.begin(), more.end());
    } catch (const PatchTooSmall& where) {
      give_up(std::string("the part cut out of the base did not suffice for ") + where.where);
      return;  // nor for more round it
    }
  }
}

/// Finishes a mesh, with nodes inserted where the boundary is not all there: as long as the peeled
/// mesh shows that by itself, and then where verification finds it. Returns their number.
std::uint32_t finish_repaired(Candidate& c, const MeshingTask& task, const MeshPatch& patch,
                              const SampledBoundary& boundary) {
  const CellularModel& cells = task.cells;
  const SizeField& sizes = task.density.sizes;
  const bool clean_up = task.options.clean_up;
  const auto most = static_cast<std::uint32_t>(
      few_more_nodes(static_cast<double>(c.nodes.size() + c.nodes.elsewhere)));
  std::uint32_t repaired = 0;
  const auto insert_at = [&](std::span<const MeshDefect> defects) {
    const std::int32_t first = c.nodes.size();
    if (c.too_fine ||
        insert_where_missing(c.nodes, defects, cells.boundary, boundary.samples, sizes) == 0)
      return false;
    c.loop.mesh = with_nodes_inserted(c.loop.mesh, first, c.nodes, cells.boundary, sizes, task.run);
    repaired += c.nodes.size() - first;
    const double verified = c.verify_seconds;
    c = extract(std::move(c.nodes), std::move(c.loop), task, patch, boundary.inside);
    c.verify_seconds = verified;
    c.too_fine = repaired > most;
    return true;
  };
  int rounds_at_facets = 0;
  const auto insert_at_facets = [&] {
    for (; rounds_at_facets < kRepairs.rounds && !c.delaunay.nonconforming.empty();
         ++rounds_at_facets)
      if (!insert_at(nonconforming_facets(c.delaunay))) break;
  };
  insert_at_facets();
  // Where the peeled mesh lacks a part of the boundary, no clean-up brings it back.
  const bool sized = !task.options.sizing.even;
  const auto finish_complete = [&] {
    finish(c, task, patch, false);
    if (clean_up && boundary_is_complete(c.verification)) finish(c, task, patch, true);
  };
  if (sized && repaired > 0)
    finish_complete();
  else
    finish(c, task, patch, clean_up);
  const auto faults = [&] {
    const auto& counts = c.verification.counts;
    return std::accumulate(counts.begin(), counts.end(), 0.0);
  };
  double last = HUGE_VAL;
  for (int round = 0; round < kRepairs.rounds && !c.verification.valid; ++round) {
    if (sized && faults() > kRepairs.fewer * last) break;
    last = faults();
    if (!insert_at(c.verification.failures)) break;
    insert_at_facets();
    finish_complete();
  }
  return repaired;
}

}  // namespace

double few_more_nodes(double nodes) {
  return kRepairs.few_inserted + kRepairs.most_inserted * nodes;
}

Candidate extract_verified(const MeshingTask& task, PatchNodes local, OptimiseResult loop,
                           const SampledBoundary& boundary, Attempt& attempt) {
  Stopwatch watch;
  Candidate mesh =
      extract(std::move(local.nodes), std::move(loop), task, local.patch, boundary.inside);
  const std::uint32_t inserted = finish_repaired(mesh, task, local.patch, boundary);
  if (!mesh.verification.valid) confine(mesh, task, local.patch, boundary.inside, attempt);
  attempt.counts.nodes_inserted = inserted;
  dump_text(task.run, "09-verify", [&] { return to_text(mesh.verification); });
  if (inserted > 0)
    attempt.warnings.push_back({.code = WarningCode::NodesInserted,
                                .message = std::to_string(inserted) +
                                           " nodes were inserted to make the boundary complete"});
  watch.lap(attempt.seconds.extract);
  attempt.seconds.verify += mesh.verify_seconds;
  return mesh;
}

void judge(const Strategy& how, const Problem& problem, Attempt& attempt) {
  const Candidate& mesh = *attempt.candidate();
  const bool larger_patch = std::isfinite(how.reach) && !how.last_reach;
  if (mesh.verification.valid && (mesh.bad_at_interface == 0 || !larger_patch)) return;
  if (mesh.bad_at_interface > 0 && larger_patch && (mesh.verification.valid || mesh.too_fine)) {
    attempt.reason = std::to_string(mesh.bad_at_interface) +
                     " tets beside what stays of the base could not be cleaned up";
    return;
  }
  attempt.fault = describe_fault(mesh, problem);
  attempt.reason = attempt.fault->message;
  attempt.too_fine = mesh.too_fine;
  if (mesh.too_fine) attempt.reason += "; its boundary takes far more nodes than were asked for";
}

}  // namespace remeshd
