#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/improve/boundary_rules.h"
#include "engine/improve/local_mesh.h"
#include "engine/improve/score.h"
#include "engine/mesh/quality.h"

namespace remeshd {

/// What reconnections compare tets by: the measure, or a score.
class TetQuality {
 public:
  TetQuality() = default;
  /// Keeps a reference.
  explicit TetQuality(const Score& score) : score_(&score) {}
  /// Tets of the mesh count as worth `most` at most, so that worse ones may take their place.
  TetQuality(const Score& score, double most) : score_(&score), most_(most) {}
  double operator()(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    return score_ ? (*score_)(a, b, c, d) : volume_length(a, b, c, d);
  }
  double operator()(const LocalMesh& mesh, std::int32_t t) const {
    return std::min(most_, score_ ? (*score_)(mesh, t) : mesh.quality(t));
  }

 private:
  const Score* score_ = nullptr;
  double most_ = std::numeric_limits<double>::infinity();
};

/// Tets to be taken out and those that fill the same room.
struct Reconnection {
  std::vector<std::int32_t> old_tets;
  std::vector<Tet> fresh;
  double quality = 0;  ///< worth of the worst of the fresh tets, +infinity where there are none
  void clear() {
    old_tets.clear();
    fresh.clear();
  }
};

/// Takes the edge a-b out of its ring of tets: the ring's polygon is triangulated so that the worst
/// of the two tets on each triangle is best (dynamic programming, Klincsek 1980). On the boundary,
/// where the rules allow it, the surface's diagonal is swapped with it: a ring of two tets is a 2-2
/// flip, a lone tet is peeled.
///
/// Post: false, and `out` undefined, unless the worst fresh tet is better than `floor` and than the
/// worst of the ring.
/// Source: Freitag & Ollivier-Gooch 1997; Shewchuk 2002, "Two discrete optimization algorithms for
/// the topological improvement of tetrahedral meshes".
bool remove_edge(const LocalMesh& mesh, const BoundaryRules& rules, std::int32_t a, std::int32_t b,
                 int max_ring, double floor, Reconnection& out, const TetQuality& quality = {});

/// Takes out the facet opposite a tet's corner, and with it those neighbouring facets between the
/// same two apexes whose removal helps, and joins the apexes by an edge: a 2-3 flip where it is one
/// facet alone. Same postcondition.
/// Source: Shewchuk 2002, multi-face removal.
bool remove_faces(const LocalMesh& mesh, std::int32_t tet, int corner, double floor,
                  Reconnection& out, const TetQuality& quality = {});

}  // namespace remeshd
