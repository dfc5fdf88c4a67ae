#include "engine/remesh/finish/patch_mesh.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <utility>

#include "engine/extract/peel.h"
#include "engine/improve/improve.h"
#include "engine/nodes/dump.h"
#include "engine/optimise/live_mesh.h"
#include "engine/patch/node_map.h"
#include "engine/patch/stitch.h"

namespace remeshd {
namespace {

// As ImproveOptions::most_left, where edge lengths differ. With any number left an edit of a part
// with 12,000 nodes spent minutes on neighbourhoods full of bad tets.
constexpr std::size_t kMostLeftSized = 2;

/// Finds what is known from before the edit of the tets of a patch's new Delaunay mesh and of their
/// exterior neighbours: which are in the model.
class PatchClassifier {
 public:
  PatchClassifier(const NodeSet& nodes, const DelaunayMesh& mesh, const MeshPatch& patch,
                  const CopyPlan& plan)
      : nodes_(nodes),
        mesh_(mesh),
        patch_(patch),
        plan_(plan),
        known_(KnownClassification::nothing(mesh, patch.exterior)) {}

  KnownClassification known() {
    find_unchanged();
    if (!gone_.empty()) find_outside_still();
    return std::move(known_);
  }

 private:
  /// The nodes counterclockwise as seen from outside of the tet, the least of them first.
  using Facet = std::array<std::int32_t, 3>;

  static Facet facet_of(const Tet& t, int opposite) {
    const auto& f = kTetFacets[opposite];
    Facet facet{t[f[0]], t[f[1]], t[f[2]]};
    std::ranges::rotate(facet, std::ranges::min_element(facet));
    return facet;
  }

  /// The number that a node had in the patch before the edit; -1: it is new or has moved.
  [[nodiscard]] std::int32_t before(std::int32_t node) const {
    if (node < 0) return -1;
    const std::int32_t then = nodes_.original[node];
    return then >= 0 && nodes_.positions[node] == patch_.positions[then] ? then : -1;
  }

  /// Classifies tets that are as before, by whether they meet a changed box; notes the tets that
  /// are gone.
  void find_unchanged() {
    // A mesh that was built anew has its tets in other slots, and may have fewer slots.
    const auto then_slots = static_cast<std::int32_t>(patch_.mesh.slots());
    for (std::int32_t s = 0; s < then_slots; ++s) {
      if (!patch_.mesh.in_use(s)) continue;
      const Tet then = patch_.mesh.corners(s);
      if (is_now(s, then)) {
        if (patch_.inside[s] == 0)
          known_.tets[s] = outside_before(s);
        else if (!meets_changed(s))
          known_.tets[s] = KnownClassification::Known::Inside;
      } else if (std::ranges::min(then) >= 0) {
        gone_.push_back(s);
      }
    }
  }

  [[nodiscard]] bool is_now(std::int32_t slot, const Tet& then) const {
    if (slot >= static_cast<std::int32_t>(mesh_.slots()) || !mesh_.in_use(slot)) return false;
    return std::ranges::equal(then, mesh_.corners(slot), [&](std::int32_t a, std::int32_t b) {
      return a < 0 || b < 0 ? a == b : a == before(b);  // super vertices
    });
  }

  /// The class of a tet in a place that was outside of the model.
  [[nodiscard]] KnownClassification::Known outside_before(std::int32_t slot) const {
    using enum KnownClassification::Known;
    return meets_changed(slot) ? WasOutside : Outside;
  }
  [[nodiscard]] bool meets_changed(std::int32_t slot) const {
    return plan_.meets_changed(mesh_.corners(slot), nodes_.positions);
  }

  /// Classifies new tets whose nodes all stayed, in the place of tets that were outside of the
  /// model. Outside of a round face a node that moves replaces the tets whose circumballs it enters
  /// or leaves, however far away they are. The centroid of a tet that comes in their place may lie
  /// between the face and its chords, inside of the model, though the tet is outside.
  void find_outside_still() {
    const std::vector<Other> others = other_tets();
    const std::vector<GoneFacet> gone = gone_facets(others);
    for (const auto& [s, then] : others) {
      int outside = 0, inside = 0;
      for (int i = 0; i < 4; ++i) {
        const Facet facet = facet_of(then, i);
        const auto was = std::ranges::lower_bound(gone, facet, {}, &GoneFacet::first);
        if (was != gone.end() && was->first == facet) ++(was->second != 0 ? inside : outside);
      }
      if (outside > 0 && inside == 0) known_.tets[s] = outside_before(s);
    }
  }

  /// A tet that is not known from before, but whose nodes all stayed; `then`: their numbers before.
  struct Other {
    std::int32_t slot;
    Tet then;
  };
  using GoneFacet = std::pair<Facet, std::uint8_t>;  ///< of a tet that is gone; 1: it was inside

  [[nodiscard]] std::vector<Other> other_tets() const {
    std::vector<Other> others;
    for (std::int32_t s = 0; s < static_cast<std::int32_t>(mesh_.slots()); ++s) {
      if (!mesh_.in_use(s) || known_.tets[s] != KnownClassification::Known::No) continue;
      Tet then = mesh_.corners(s);
      for (std::int32_t& n : then) n = before(n);
      if (std::ranges::min(then) >= 0) others.push_back({s, then});
    }
    return others;
  }

  /// Facets of tets that are gone, between nodes of the others; ascending.
  [[nodiscard]] std::vector<GoneFacet> gone_facets(const std::vector<Other>& others) const {
    std::vector<std::uint8_t> asked(patch_.positions.size(), 0);
    for (const Other& other : others)
      for (const std::int32_t n : other.then) asked[n] = 1;
    std::vector<GoneFacet> facets;
    for (const std::int32_t s : gone_)
      for (int i = 0; i < 4; ++i) {
        const Facet facet = facet_of(patch_.mesh.corners(s), i);
        if (std::ranges::all_of(facet, [&](std::int32_t n) { return asked[n] != 0; }))
          facets.emplace_back(facet, patch_.inside[s]);
      }
    std::ranges::sort(facets);
    return facets;
  }

  const NodeSet& nodes_;
  const DelaunayMesh& mesh_;
  const MeshPatch& patch_;
  const CopyPlan& plan_;
  KnownClassification known_;
  std::vector<std::int32_t> gone_;  ///< slots of patch tets that are gone, none at super vertices
};

/// Supports of the parent's nodes in the modified boundary; nodes in the patch may have any.
/// Throws PatchTooSmall where another one has none there.
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

/// The patch's peeled Delaunay mesh, all of it dirty.
ReusedMesh all_new(const Candidate& c) {
  const std::vector<Tet>& tets = c.delaunay.tets;
  return {{c.nodes.positions, tets}, std::vector<std::uint8_t>(tets.size(), 1), {}};
}

}  // namespace

DroppedNodes drop_unused(NodeSet& nodes, std::vector<Tet>& tets, DelaunayMesh& mesh,
                         const Run& run) {
  DroppedNodes dropped{.number = std::vector<std::int32_t>(nodes.positions.size(), -1)};
  std::vector<std::int32_t>& number = dropped.number;
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
  if (unused.empty()) return dropped;
  nodes.resize(next);
  for (Tet& t : tets) t = renamed(t, number);
  if (mesh.remove(unused, run)) {
    mesh.rename(number, next);
  } else {
    dropped.rebuilt = true;
    mesh = mesh.emptied();
    std::vector<std::int32_t> all(next);
    std::iota(all.begin(), all.end(), 0);
    mesh.insert(nodes.positions, all, run);
  }
  if (mesh.patch_too_small()) throw PatchTooSmall{"leaving out nodes"};
  return dropped;
}

PeeledMesh peeled(const Candidate& c, const MeshingTask& task, const MeshPatch& patch,
                  const InsideTest& inside) {
  return peel(c.nodes, c.loop.mesh, task.cells.boundary, inside,
              PatchClassifier(c.nodes, c.loop.mesh, patch, task.plan).known(),
              {.by_centroid_only = task.options.sizing.even && task.density.sizes.even()},
              task.run);
}

Candidate extract(NodeSet nodes, OptimiseResult loop, const MeshingTask& task,
                  const MeshPatch& patch, const InsideTest& inside) {
  Candidate c;
  c.loop = std::move(loop);
  c.nodes = std::move(nodes);
  task.run.report("extract", 0.8);
  do {
    c.delaunay = peeled(c, task, patch, inside);
  } while (drop_unused(c.nodes, c.delaunay.tets, c.loop.mesh, task.run).rebuilt);
  dump_nodes(task.run, "08-peel", c.nodes, task.density.sizes, c.delaunay.tets);
  return c;
}

std::vector<std::int32_t> looked_up(std::span<const std::int32_t> values,
                                    std::span<const std::int32_t> at) {
  std::vector<std::int32_t> result(at.size(), -1);
  if (values.empty()) return result;
  for (std::size_t k = 0; k < at.size(); ++k)
    if (at[k] >= 0) result[k] = values[at[k]];
  return result;
}

ReusedMesh cleaned_up(Candidate& c, const MeshingTask& task, const MeshPatch& patch,
                      bool clean_up) {
  const MeshOptions& options = task.options;
  // Even meshes are to stay as older versions made them, with cavities that a flip breaks.
  std::function<bool(const Tet&)> unchanged;
  if (!options.sizing.even)
    unchanged = [&](const Tet& t) { return !task.plan.meets_changed(t, c.nodes.positions); };
  ReusedMesh reused = options.clean_up
                          ? reuse_improved_tets(c.nodes, c.delaunay, patch, task.plan.transforms(),
                                                unchanged, task.run)
                          : all_new(c);
  task.run.report("improve", 0.85);
  c.bad_at_interface = 0;
  if (!clean_up) return reused;
  ImproveResult improved = improve(reused.mesh, c.nodes.supports, task.cells.boundary, reused.dirty,
                                   {.threshold = options.threshold,
                                    .locked = c.nodes.interface_nodes,
                                    .confined = !options.sizing.even,
                                    .most_left = options.sizing.even ? 1U : kMostLeftSized},
                                   task.run);
  c.bad_at_interface = improved.bad_at_interface;
  return {
      std::move(improved.mesh),
      {},
      {looked_up(reused.same.peeled, improved.was), looked_up(reused.same.output, improved.was)}};
}

void put_back(Candidate& c, const ReusedMesh& mesh, const MeshingTask& task, const MeshPatch& patch,
              std::uint32_t most_failures) {
  const CellularModel& cells = task.cells;
  c.whole = {};  // frees its memory before it is made again
  // Even meshes are to stay as older versions made them, with connected cavities.
  const PatchMesh made{
      c.nodes,    c.loop.mesh,
      c.delaunay, mesh.mesh,
      mesh.same,  task.options.sizing.even ? CavityExtent::Connected : CavityExtent::Least};
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

}  // namespace remeshd
