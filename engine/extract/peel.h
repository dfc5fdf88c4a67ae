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
  /// Whether tets whose nodes are all on the boundary are classified by their centroids only. Else
  /// those that are thin against a curved face are classified by their facets on it
  /// (`side_by_facets`), and the others also count as outside if an edge between nodes of different
  /// faces lies outside, such as one across a gap.
  bool by_centroid_only = true;
  double flat = 0.3;  ///< volume-length below which a tet on one curved face is peeled
};

/// Which tets of a new Delaunay mesh are known, from before the edit, to be in the model or not.
struct KnownClassification {
  enum class Known : std::uint8_t {
    No,
    Inside,
    Outside,
    WasOutside,  ///< outside before the edit, but the model may have changed there
  };
  /// Nothing is known of the tets; `exterior`: that of a patch, empty for a whole mesh.
  static KnownClassification nothing(const DelaunayMesh& mesh,
                                     std::vector<std::uint8_t> exterior = {}) {
    return {std::vector(mesh.slots(), Known::No), std::move(exterior)};
  }
  std::vector<Known> tets;             ///< by slot of the Delaunay mesh
  std::vector<std::uint8_t> exterior;  ///< by PagedDelaunay::Cut::exterior: 1 if in the model
};

struct PeeledMesh {
  std::vector<Tet> tets;
  std::vector<std::int32_t> slots;  ///< by tet: its slot in the Delaunay mesh, ascending
  /// Centroids of boundary facets whose nodes share no face: there the boundary has too few nodes
  /// for a triangulation of it to be in the Delaunay mesh.
  std::vector<Vec3> nonconforming;
};

/// Takes the mesh of the model out of the Delaunay mesh of its nodes: tets with an interior node
/// are inside; of the others, those whose centroid lies in the model (Sect. 3.4; `options` may ask
/// for more tests). Tets whose four nodes lie on one face are flat against it. On a plane they are
/// outside; where more tests are asked for, those between tets in the model stay, as within the rim
/// of a pin that stands on the face. On a curved face a tet of low quality is peeled once exactly
/// two of its facets are exposed, and these, where more tests are asked for, on no other face; or
/// three if one of them looks away from the face; a tet known as WasOutside once two or more are.
///
/// The rim of a group: on a plane, faces that only a rim separates count as one face; on a curved
/// surface, shallow tets with nodes on both sides of a rim are outside.
///
/// Tets known as Inside are not tested; those known as Outside are peeled.
/// `known`: an entry for each slot of `delaunay`.
PeeledMesh peel(const NodeSet& nodes, const DelaunayMesh& delaunay, const BoundaryModel& boundary,
                const InsideTest& inside, const KnownClassification& known,
                const PeelOptions& options, const Run& run);

}  // namespace remeshd
