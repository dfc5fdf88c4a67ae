#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/inside_test.h"
#include "engine/base/run.h"
#include "engine/delaunay/delaunay_mesh.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/nodes/node_set.h"

namespace remeshd {

struct PeelOptions {
  /// Whether tets of boundary nodes alone are inside or outside by their centroids only. Else those
  /// that are thin against a curved face are by their facets on it, and others are outside, too,
  /// where an edge between nodes of different faces is, as from side to side of a gap.
  bool by_centroid_only = true;
  double flat = 0.3;  ///< volume-length below which a tet on one curved face is peeled
};

/// What is known of a mesh's tets from before.
struct KnownClassification {
  enum class Known : std::uint8_t {
    No,
    Inside,
    Outside,
    WasOutside,  ///< in a model that may have been another there
  };
  /// Nothing; `exterior`: of a patch.
  static KnownClassification nothing(const DelaunayMesh& mesh,
                                     std::vector<std::uint8_t> exterior = {}) {
    return {std::vector(mesh.slots(), Known::No), std::move(exterior)};
  }
  std::vector<Known> tets;             ///< by slot: whether it is in the model
  std::vector<std::uint8_t> exterior;  ///< by number of PagedDelaunay::Cut::exterior: 1 if it is
};

struct PeeledMesh {
  std::vector<Tet> tets;
  std::vector<std::int32_t> slots;  ///< by tet: its slot in the Delaunay mesh, ascending
  /// Centroids of boundary facets whose nodes share no face: where the boundary is too thinly
  /// occupied for its facets to be Delaunay.
  std::vector<Vec3> nonconforming;
};

/// Takes the mesh of the model out of the Delaunay mesh of its nodes: tets with an interior node
/// are inside; of the others, those whose centroid lies in the model (Sect. 3.4). Tets whose four
/// nodes lie on one face are flat against it: on a plane they go, on a curved face they go where
/// they show two facets, or, of those that were outside, more, and are of low quality.
///
/// `known`: of all slots.
PeeledMesh peel(const NodeSet& nodes, const DelaunayMesh& delaunay, const BoundaryModel& boundary,
                const InsideTest& inside, const KnownClassification& known,
                const PeelOptions& options, const Run& run);

}  // namespace remeshd
