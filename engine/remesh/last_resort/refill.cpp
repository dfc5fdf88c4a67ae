#include "engine/remesh/last_resort/refill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "engine/base/error.h"
#include "engine/boundary/cover/cover_faces.h"
#include "engine/boundary/facet_faces.h"
#include "engine/boundary/material.h"
#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/cellular/boundary_model/sharp_places.h"
#include "engine/kernel/tetgen.h"
#include "engine/mesh/grouping.h"
#include "engine/nodes/nearest.h"

namespace remeshd {
namespace {

struct RefillLimits {
  double closest = 0.35;             ///< x edge length: of an inner node from the shell
  std::uint32_t most_added = 2'000;  ///< points by TetGen, beside as many as the shell has
};
constexpr RefillLimits kRefillLimits;

using Side = std::pair<std::int32_t, std::int32_t>;

Side side_of(std::int32_t a, std::int32_t b) { return {std::min(a, b), std::max(a, b)}; }

Triangle sorted(Triangle t) {
  std::ranges::sort(t);
  return t;
}

class Refiller {
 public:
  Refiller(const FaultyMesh& faulty, const BoundaryModel& boundary, const SizeField& sizes,
           const Run& run)
      : faulty_(faulty), boundary_(boundary), sizes_(sizes), run_(run) {
    const PagedMesh& mesh = faulty.whole.mesh;
    mesh.nodes.for_each([&](std::size_t, const Vec3& p) { open_.mesh.nodes.push_back(p); });
    faulty.whole.delaunay_state.supports.for_each(
        [&](std::size_t, const Support& s) { open_.mesh.supports.push_back(s); });
    mesh.tets.for_each([&](std::size_t, const Tet& t) { tets_.push_back(t); });
    node_count_ = open_.mesh.nodes.size();
    at_node_ = grouped<std::int32_t>(node_count_, [&](const auto& visit) {
      for (std::size_t t = 0; t < tets_.size(); ++t)
        for (const std::int32_t n : tets_[t]) visit(n, static_cast<std::int32_t>(t));
    });
    patch_tet_.assign(tets_.size(), -1);
    patch_node_.assign(node_count_, -1);
    for (std::size_t k = 0; k < faulty.whole.new_tets.size(); ++k) {
      const std::int32_t t = faulty.whole.new_tets[k];
      patch_tet_[t] = static_cast<std::int32_t>(k);
      for (int i = 0; i < 4; ++i) patch_node_[tets_[t][i]] = faulty.patch.tets[k][i];
    }
    goes_.assign(tets_.size(), 0);
    open_.finer_at.assign(faulty.wrong_again.begin(), faulty.wrong_again.end());
  }

  std::variant<RefilledMesh, std::string> refill(double margin) {
    std::string failed = take_out(margin);
    if (failed.empty()) failed = find_walls();
    if (failed.empty()) failed = cover_open_faces(open_, boundary_, sizes_, run_);
    if (!failed.empty()) return failed;
    if (!is_closed()) return std::string("what was covered does not close the place off");
    if (!is_of_patch()) return std::string("it reaches beyond what may change");
    try {
      return filled();
    } catch (const Error& e) {
      const std::string& reason = e.info().reason;
      if (reason != "TETGEN_REFUSED" && reason != "TETGEN_CRASHED") throw;
      return e.info().message;
    }
  }

 private:
  void take(std::int32_t t) {
    if (std::exchange(goes_[t], 1) == 0) changed_ = true;
  }

  /// Marks the tets that go: those with a node near a faulty place, those with a boundary facet on
  /// no face, and those that would touch the open part of the boundary at an edge or node only.
  /// Returns why that cannot be done; empty: it is done.
  std::string take_out(double margin) {
    // A node that is in no tet, or off its support, is not to be used on the boundary.
    for (const MeshDefect& defect : faulty_.verification.failures)
      if (defect.kind == MeshFailure::NodeOffSupport) open_.mesh.supports[defect.entity] = {};
    for (std::size_t n = 0; n < node_count_; ++n)
      if (at_node_[n].empty()) open_.mesh.supports[n] = {};
    const FacetFaces faces(boundary_, open_.mesh.supports);
    const auto& p = open_.mesh.nodes;
    const NearestNode grid(p, kGridCell * sizes_.grid_length());
    for (const Vec3& place : faulty_.places)
      grid.for_each_within(place, margin * sizes_(place), [&](std::int32_t n, double) {
        for (const std::int32_t t : at_node_[n])
          if (patch_tet_[t] >= 0) take(t);
      });
    for (const SurfaceFacet& f : faulty_.verification.surface) {
      face_of_.push_back(faces.face_of(f.nodes, p[f.nodes[0]], p[f.nodes[1]], p[f.nodes[2]]));
      if (face_of_.back() < 0) take(f.tet);
    }
    do {
      run_.poll();
      changed_ = false;
      take_contacts();
    } while (changed_);
    for (std::size_t t = 0; t < goes_.size(); ++t)
      if (goes_[t] != 0 && patch_tet_[t] < 0) return "it reaches beyond what may change";
    return {};
  }

  /// Marks the tets at edges and nodes of the boundary all of whose boundary facets go.
  void take_contacts() {
    std::vector<std::uint8_t> node_open(node_count_, 0), node_stays(node_count_, 0);
    std::map<Side, bool> stays;  // sides of facets that go: whether one that stays has them too
    for (const SurfaceFacet& f : faulty_.verification.surface)
      if (goes_[f.tet] != 0)
        for (int i = 0; i < 3; ++i) {
          node_open[f.nodes[i]] = 1;
          stays[side_of(f.nodes[i], f.nodes[(i + 1) % 3])] = false;
        }
    for (const SurfaceFacet& f : faulty_.verification.surface)
      if (goes_[f.tet] == 0)
        for (int i = 0; i < 3; ++i) {
          node_stays[f.nodes[i]] = 1;
          const auto side = stays.find(side_of(f.nodes[i], f.nodes[(i + 1) % 3]));
          if (side != stays.end()) side->second = true;
        }
    for (std::size_t n = 0; n < node_count_; ++n)
      if (node_open[n] != 0 && node_stays[n] == 0)
        for (const std::int32_t t : at_node_[n]) take(t);
    for (const auto& [side, stay] : stays)
      if (!stay)
        for (const std::int32_t t : at_node_[side.first])
          if (std::ranges::count(tets_[t], side.second) > 0) take(t);
  }

  /// Fills `open_`: the walls between tets that go and those that stay, the boundary facets that
  /// stay, and the loose nodes. Returns why that cannot be done; empty: it is done.
  std::string find_walls() {
    std::set<Triangle> on_boundary;
    std::vector<std::uint8_t> stays(node_count_, 0);
    for (std::size_t k = 0; k < face_of_.size(); ++k) {
      const SurfaceFacet& f = faulty_.verification.surface[k];
      if (goes_[f.tet] != 0) {
        on_boundary.insert(sorted(f.nodes));
        continue;
      }
      open_.mesh.facets.push_back({f.nodes, {-1, -1, -1}, face_of_[k]});
      for (const std::int32_t n : f.nodes) stays[n] = 1;
    }
    std::map<Triangle, std::pair<int, Triangle>> facets;
    std::vector<std::uint8_t> gone(node_count_, 0);
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      if (goes_[t] == 0) continue;
      for (const auto& corners : kTetFacets) {
        const Triangle f{tets_[t][corners[0]], tets_[t][corners[1]], tets_[t][corners[2]]};
        auto& [times, nodes] = facets[sorted(f)];
        ++times;
        nodes = f;
      }
      for (const std::int32_t n : tets_[t]) gone[n] = 1;
    }
    if (facets.empty()) return "no tet is near what is wrong";
    for (const auto& [key, facet] : facets)
      if (facet.first == 1 && !on_boundary.contains(key)) open_.walls.push_back(facet.second);
    for (std::size_t n = 0; n < node_count_; ++n)
      if (gone[n] != 0 && stays[n] == 0) open_.loose.push_back(static_cast<std::int32_t>(n));
    kept_facets_ = open_.mesh.facets.size();
    return {};
  }

  /// Whether walls and cover are a closed surface: they have every side as often in one direction
  /// as in the other.
  [[nodiscard]] bool is_closed() const {
    std::map<Side, int> turns;
    const auto add = [&](const Triangle& t) {
      for (int i = 0; i < 3; ++i) {
        const std::int32_t a = t[i], b = t[(i + 1) % 3];
        turns[side_of(a, b)] += a < b ? 1 : -1;
      }
    };
    for (const Triangle& w : open_.walls) add(w);
    for (std::size_t k = kept_facets_; k < open_.mesh.facets.size(); ++k)
      add(open_.mesh.facets[k].nodes);
    return std::ranges::all_of(turns, [](const auto& side) { return side.second == 0; });
  }

  /// Whether the nodes of the cover are new or the patch's.
  [[nodiscard]] bool is_of_patch() const {
    for (std::size_t k = kept_facets_; k < open_.mesh.facets.size(); ++k)
      for (const std::int32_t n : open_.mesh.facets[k].nodes)
        if (static_cast<std::size_t>(n) < node_count_ && patch_node_[n] < 0) return false;
    return true;
  }

  /// The patch with what walls and cover enclose filled by TetGen.
  RefilledMesh filled() const {
    kernel::MarkedSurface shell;
    std::vector<std::int32_t> number(open_.mesh.nodes.size(), -1), node_of;
    const auto add_point = [&](std::int32_t n) {
      number[n] = static_cast<std::int32_t>(node_of.size());
      node_of.push_back(n);
      shell.surface.points.push_back(open_.mesh.nodes[n]);
    };
    const auto add = [&](Triangle t) {
      for (std::int32_t& n : t) {
        if (number[n] < 0) add_point(n);
        n = number[n];
      }
      shell.surface.triangles.push_back(t);
      shell.triangle_markers.push_back(1);
    };
    for (const Triangle& w : open_.walls) add(w);
    for (std::size_t k = kept_facets_; k < open_.mesh.facets.size(); ++k)
      add(open_.mesh.facets[k].nodes);
    const auto points = static_cast<std::uint32_t>(node_of.size());
    for (const std::int32_t n : inner_nodes(shell.surface))
      if (number[n] < 0) add_point(n);
    const kernel::QualityMesh out = kernel::run_tetgen(
        shell,
        {.max_volume = 0, .split_surface = false, .most_added = kRefillLimits.most_added + points},
        {}, run_);
    return put_together(tets_in_material(out.filling, shell.surface), out.filling.mesh.nodes,
                        node_of);
  }

  /// Interior nodes of tets that go; without those too near to the shell.
  [[nodiscard]] std::vector<std::int32_t> inner_nodes(const kernel::TetGenSurface& shell) const {
    std::vector<Box> boxes;
    for (const Triangle& t : shell.triangles) boxes.push_back(box_of(shell.points, t));
    std::vector<std::int32_t> inner;
    for (const std::int32_t n : open_.loose) {
      if (open_.mesh.supports[n].kind != Support::Kind::Interior) continue;
      const Vec3& p = open_.mesh.nodes[n];
      const double closest = kRefillLimits.closest * sizes_(p);
      bool crowds = false;
      for (std::size_t k = 0; k < boxes.size() && !crowds; ++k) {
        if (!boxes[k].contains(p, closest)) continue;
        const Triangle& t = shell.triangles[k];
        crowds = triangle_distance2(p, {shell.points[t[0]], shell.points[t[1]],
                                        shell.points[t[2]]}) < closest * closest;
      }
      if (!crowds) inner.push_back(n);
    }
    return inner;
  }

  /// The patch's mesh of the tets that stay and the filling. `used`: nodes that TetGen was given.
  /// It may leave out or move inner ones, so that its `points` are matched to them by position.
  [[nodiscard]] RefilledMesh put_together(const std::vector<Tet>& filling,
                                          const std::vector<Vec3>& points,
                                          std::span<const std::int32_t> used) const {
    RefilledMesh made;
    made.mesh.nodes = faulty_.patch.nodes;
    const auto add_node = [&](const Vec3& p, const Support& support) {
      made.mesh.nodes.push_back(p);
      made.supports.push_back(support);
      return static_cast<std::int32_t>(made.mesh.nodes.size()) - 1;
    };
    const auto place = [](const Vec3& p) { return std::array{p.x, p.y, p.z}; };
    std::map<std::array<double, 3>, std::int32_t> at;
    for (const std::int32_t n : used) {
      const Vec3& p = open_.mesh.nodes[n];
      at[place(p)] = static_cast<std::size_t>(n) < node_count_
                         ? patch_node_[n]
                         : add_node(p, open_.mesh.supports[n]);
    }
    std::vector<std::int32_t> node_of;
    for (const Vec3& p : points) {
      const auto known = at.find(place(p));
      node_of.push_back(known != at.end() ? known->second : add_node(p, {}));
    }
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      const std::int32_t k = patch_tet_[t];
      if (k < 0 || goes_[t] != 0) continue;
      made.mesh.tets.push_back(faulty_.patch.tets[k]);
      made.was.push_back(k);
    }
    for (const Tet& t : filling) made.mesh.tets.push_back(renamed(t, node_of));
    made.was.resize(made.mesh.tets.size(), -1);
    return made;
  }

  const FaultyMesh& faulty_;
  const BoundaryModel& boundary_;
  const SizeField& sizes_;
  const Run& run_;
  OpenSurface open_;  ///< in the whole mesh's numbers
  std::vector<Tet> tets_;
  std::size_t node_count_ = 0;  ///< of the whole mesh
  Grouping<std::int32_t> at_node_;
  std::vector<std::int32_t> patch_tet_, patch_node_;  ///< -1 outside of the patch
  std::vector<std::uint8_t> goes_;                    ///< by tet
  std::vector<std::int32_t> face_of_;                 ///< by boundary facet
  std::size_t kept_facets_ = 0;
  bool changed_ = false;
};

}  // namespace

std::variant<RefilledMesh, std::string> refill(const FaultyMesh& faulty,
                                               const BoundaryModel& boundary,
                                               const SizeField& sizes, double margin,
                                               const Run& run) {
  return Refiller(faulty, boundary, sizes, run).refill(margin);
}

bool only_tets_are_wrong(const Verification& verification) {
  const auto& counts = verification.counts;
  return std::accumulate(counts.begin(), counts.end(), 0U) ==
         verification.count(MeshFailure::BadTet) + verification.count(MeshFailure::OutsideTet);
}

std::vector<std::uint8_t> worth_improving(const TetMesh& made, std::span<const std::int32_t> was,
                                          const ReusedMesh& before,
                                          std::span<const Support> supports,
                                          const BoundaryModel& boundary, double thinner_than) {
  const ThinWalls films(boundary, thinner_than);
  std::vector<std::uint8_t> dirty(made.tets.size(), 1);
  for (std::size_t k = 0; k < dirty.size(); ++k) {
    if (was[k] >= 0 && (before.dirty.empty() || before.dirty[was[k]] == 0)) {
      dirty[k] = 0;
      continue;
    }
    std::array<Support, 4> stands;
    std::array<Vec3, 4> nodes;
    for (int i = 0; i < 4; ++i) {
      stands[i] = supports[made.tets[k][i]];
      nodes[i] = made.nodes[made.tets[k][i]];
    }
    if (films.holds(stands, nodes)) dirty[k] = 0;
  }
  return dirty;
}

}  // namespace remeshd
