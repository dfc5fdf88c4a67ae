#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/cellular/support.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/verify/surface_facets.h"

namespace remeshd {

/// What can be wrong with a finished mesh.
enum class MeshFailure : std::uint8_t {
  BadTet,          ///< inverted or flat
  BadFacet,        ///< in three tets or more, or two tets on the same side of it
  OpenBoundary,    ///< an edge of the boundary that is not in exactly two boundary facets
  PinchedNode,     ///< a boundary node whose boundary facets form more than one fan
  MissingVertex,   ///< a model vertex that no boundary node stands on
  BrokenEdge,      ///< a model edge that is no chain of boundary edges from its start to its end
  OrphanNode,      ///< a node in no tet
  NodeOffSupport,  ///< a node away from the vertex, edge or face that it is said to stand on
  StrayFacet,  ///< a boundary facet whose nodes share no model face, or that is turned over on it
  FaceArea,    ///< a model face that its facets do not cover, or cover twice
  Volume,      ///< off the exact one by more than the tolerance
};
inline constexpr std::size_t kMeshFailures = 11;

struct MeshDefect {
  MeshFailure kind{};
  std::int32_t entity = -1;  ///< tet, node, or model vertex, edge or face; -1 for the whole mesh
  Vec3 place;                ///< where a repair has to look
  std::string what;          ///< one sentence with the place in it
};

struct Verification {
  bool valid = false;
  std::array<std::uint32_t, kMeshFailures> counts{};  ///< by MeshFailure
  std::vector<MeshDefect> failures;                   ///< the first 20 of each kind
  std::vector<SurfaceFacet> surface;                  ///< the mesh's boundary, by tet
  std::uint32_t boundary_facets = 0;
  double volume = 0;  ///< of the mesh
  double chord_volume =
      0;  ///< between the facets and their curved faces; positive where the mesh lacks it
  double boundary_area = 0;

  [[nodiscard]] std::uint32_t count(MeshFailure kind) const {
    return counts[static_cast<std::size_t>(kind)];
  }
};

/// Checks a mesh against the model that it is to represent: positive tets, a closed manifold
/// boundary (by facets, edges and nodes), every model vertex, edge and face there, no node unused,
/// and the volume within `volume_tolerance` (relative) of the exact one. What flat facets cut off
/// curved faces is no defect, however coarse the mesh: it is integrated and added to the volume,
/// and areas are compared within the error that the facets' size allows.
///
/// A defect of the mesh is a value here. Throws Cancelled only.
Verification verify(const TetMesh& mesh, std::span<const Support> supports,
                    const BoundaryModel& boundary, double exact_volume, const Run& run,
                    double volume_tolerance = 0.002);

}  // namespace remeshd
