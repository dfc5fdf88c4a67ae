#include "engine/remesh/last_resort/confine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/stopwatch.h"
#include "engine/improve/improve.h"
#include "engine/optimise/live_mesh.h"
#include "engine/remesh/finish/faults.h"
#include "engine/remesh/finish/patch_mesh.h"
#include "engine/remesh/last_resort/refill.h"
#include "engine/sizing/size_rules.h"

namespace remeshd {
namespace {

struct ConfineLimits {
  std::uint32_t all_failures = 100'000;  ///< of each kind: as good as all
  double most = 0.15;                    ///< of the tets: a mesh with more faults is wrong all over
  double hopeless =
      0.1;  ///< of a refill's tets: with so many faults no clean-up or other try helps
  /// Of the faults of the refill before: another is made only after one with fewer. Of 81 meshes of
  /// the campaign 78 were valid with the first refill and one with the second, none with a later.
  double fewer = 0.7;
};
constexpr ConfineLimits kConfineLimits;
constexpr std::array kRefillMargins{1.5, 1.5, 3.0, 3.0, 6.0};  // x edge length

/// Whether so much is wrong that other refills of this mesh are in vain: between walls that all but
/// coincide whatever fills the place is flat. `made`: tets of the refill.
bool is_hopeless(const Candidate& c, std::ptrdiff_t made) {
  return static_cast<double>(c.verification.failures.size()) >
         kConfineLimits.hopeless * static_cast<double>(made);
}

/// The patch's mesh, put back and verified with all faults described. Clean-up is left out, since
/// it mends no boundary, unless the mesh is valid without it: then clean-up made the faults, and is
/// done to find them. Throws PatchTooSmall.
ReusedMesh with_all_faults(Candidate& c, const MeshingTask& task, const MeshPatch& patch) {
  ReusedMesh mesh = cleaned_up(c, task, patch, false);
  put_back(c, mesh, task, patch, kConfineLimits.all_failures);
  if (!c.verification.valid) return mesh;
  mesh = cleaned_up(c, task, patch, task.options.clean_up);
  put_back(c, mesh, task, patch, kConfineLimits.all_failures);
  return mesh;
}

/// Whether the mesh is wrong all over rather than at some places, though many nodes were inserted.
bool is_wrong_all_over(const Candidate& c, std::size_t places, std::size_t tets) {
  return c.too_fine &&
         static_cast<double>(places) > kConfineLimits.most * static_cast<double>(tets);
}

/// By tet of a patch's mesh: 1 where it was found to be wrong or has a node in common with one.
std::vector<std::uint8_t> round_faulty_tets(const Candidate& c, const TetMesh& mesh) {
  std::set<std::int32_t> faulty;
  for (const MeshDefect& defect : c.verification.failures) faulty.insert(defect.entity);
  std::vector<std::uint8_t> at_faulty(mesh.nodes.size(), 0);
  for (std::size_t k = 0; k < mesh.tets.size(); ++k)
    if (faulty.contains(c.whole.new_tets[k]))
      for (const std::int32_t n : mesh.tets[k]) at_faulty[n] = 1;
  std::vector<std::uint8_t> dirty(mesh.tets.size(), 0);
  for (std::size_t k = 0; k < mesh.tets.size(); ++k)
    for (const std::int32_t n : mesh.tets[k]) dirty[k] |= at_faulty[n];
  return dirty;
}

/// A candidate with a part of its patch refilled.
struct Refilled {
  Candidate candidate;
  std::ptrdiff_t filling = 0;    ///< tets of the refill, before clean-up
  std::ptrdiff_t made_anew = 0;  ///< tets of it, and others that were cleaned up
};

/// The mesh with a part of the patch refilled, its new nodes in the Delaunay mesh too, cleaned up
/// and verified. Throws PatchTooSmall.
Refilled with_refilled(const Candidate& c, const ReusedMesh& mesh, RefilledMesh refilled,
                       const MeshingTask& task, const MeshPatch& patch, const InsideTest& inside) {
  Refilled result;
  Candidate& next = result.candidate;
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
      drop_unused(next.nodes, refilled.mesh.tets, next.loop.mesh, task.run).number;
  for (std::size_t n = 0; n < number.size(); ++n)
    if (number[n] >= 0) refilled.mesh.nodes[number[n]] = refilled.mesh.nodes[n];
  refilled.mesh.nodes.resize(next.nodes.positions.size());
  next.delaunay = peeled(next, task, patch, inside);

  ReusedMesh made{std::move(refilled.mesh), {}, {{}, looked_up(mesh.same.output, refilled.was)}};
  std::vector<std::int32_t> was = refilled.was;
  put_back(next, made, task, patch, kConfineLimits.all_failures);
  result.filling = result.made_anew = std::ranges::count(was, -1);
  const auto improve_some = [&](const std::vector<std::uint8_t>& dirty) {
    ImproveResult improved = improve(
        made.mesh, next.nodes.supports, task.cells.boundary, dirty,
        {.threshold = task.options.threshold, .locked = next.nodes.interface_nodes}, task.run);
    was = looked_up(was, improved.was);
    made = {std::move(improved.mesh), {}, {{}, looked_up(mesh.same.output, was)}};
    put_back(next, made, task, patch, kConfineLimits.all_failures);
    result.made_anew = std::ranges::count(was, -1);
  };
  if (!task.options.clean_up || is_hopeless(next, result.made_anew)) return result;
  // What is wrong first: where that cannot be mended, it is in vain to improve the rest.
  if (!next.verification.valid && only_tets_are_wrong(next.verification) &&
      can_be_improved(made.mesh, next.verification))
    improve_some(round_faulty_tets(next, made.mesh));
  if (next.verification.valid)
    improve_some(worth_improving(made.mesh, was, mesh, next.nodes.supports, task.cells.boundary,
                                 least_size(task.options.sizing, task.density.sizes.base())));
  return result;
}

}  // namespace

void confine(Candidate& c, const MeshingTask& task, const MeshPatch& patch,
             const InsideTest& inside, Attempt& attempt) {
  const ReusedMesh mesh = with_all_faults(c, task, patch);
  const std::vector<Vec3> places = faulty_places(c.verification);
  if (is_wrong_all_over(c, places.size(), mesh.mesh.tets.size())) {
    attempt.tries.push_back({attempt.name + ", refilled",
                             "too much is wrong: " + std::to_string(places.size()) +
                                 " places of a mesh of " + std::to_string(mesh.mesh.tets.size()) +
                                 " tets",
                             0});
    return;
  }
  std::vector<Vec3> wrong_again;
  struct Tried {
    double margin = 0;
    std::size_t wrong_again = 0;
    double faults = HUGE_VAL;
  } last;
  for (const double margin : kRefillMargins) {
    if (places.empty()) return;
    if (margin == last.margin && wrong_again.size() == last.wrong_again) continue;  // same refill
    last.margin = margin;
    last.wrong_again = wrong_again.size();
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
      auto [next, filling, made_anew] =
          with_refilled(c, mesh, std::get<RefilledMesh>(std::move(made)), task, patch, inside);
      if (next.verification.valid) {
        const MeshDefect& defect = c.verification.failures.front();
        attempt.warnings.push_back({.code = WarningCode::Fallback,
                                    .message = defect.what + "; TetGen filled the place",
                                    .point = defect.place});
        c = std::move(next);
        attempt.last_resort_share = static_cast<double>(std::min(filling, made_anew)) /
                                    static_cast<double>(c.whole.mesh.tets.size());
        return;
      }
      give_up(next.verification.failures.front().what);
      if (is_hopeless(next, made_anew)) {
        attempt.hopeless = true;
        return;
      }
      const auto faults = static_cast<double>(next.verification.failures.size());
      if (faults > kConfineLimits.fewer * std::exchange(last.faults, faults)) return;
      const std::vector<Vec3> more = faulty_places(next.verification);
      wrong_again.insert(wrong_again.end(), more.begin(), more.end());
    } catch (const PatchTooSmall& where) {
      give_up(std::string("the part cut out of the base did not suffice for ") + where.where);
      return;  // a wider refill needs more
    }
  }
}

}  // namespace remeshd
