#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/base/inside_test.h"
#include "engine/cellular/boundary_model/support.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/verify/inheritance.h"

namespace remeshd {

/// What can be wrong with a finished mesh.
enum class MeshFailure : std::uint8_t {
  BadTet,             ///< inverted or flat
  BadFacet,           ///< in three tets or more, or two tets on the same side of it
  NonManifoldEdge,    ///< an edge of the boundary that is not in exactly two boundary facets
  NonManifoldVertex,  ///< a boundary node whose boundary facets form more than one fan
  MissingVertex,      ///< a model vertex that no boundary node stands on
  MissingSegment,     ///< a model edge that is no chain of boundary edges from its start to its end
  OrphanNode,         ///< a node in no tet
  NodeOffSupport,     ///< a node away from the vertex, edge or face that it is said to stand on
  NonconformingFacet,  ///< a boundary facet whose nodes share no model face, or that is turned over
                       ///< on it
  FaceArea,            ///< a model face that its facets do not cover, or cover twice
  Volume,              ///< off the exact one by more than the tolerance
  RepeatedTet,         ///< a tet with the four nodes of an earlier one
  FacetOffFace,        ///< a boundary facet further from its curved face than a chord may be, or
                       ///< across it
  OutsideTet,          ///< a tet in no cell: away from the material
};
inline constexpr std::size_t kMeshFailures = 14;

struct MeshDefect {
  MeshFailure kind{};
  std::int32_t entity = -1;  ///< tet, node, or model vertex, edge or face; -1 for the whole mesh
  Vec3 place;                ///< where a repair has to look
  std::string what;          ///< one sentence with the place in it
};

struct Verification {
  bool valid = false;
  std::array<std::uint32_t, kMeshFailures> counts{};  ///< by MeshFailure
  std::vector<MeshDefect> failures;                   ///< the first ones of each kind
  std::vector<SurfaceFacet> surface;  ///< the mesh's boundary, in the order of its tets
  std::uint32_t boundary_facets = 0;
  double volume = 0;  ///< of the mesh
  double chord_volume =
      0;  ///< between the facets and their curved faces; positive where the mesh lacks it
  double boundary_area = 0;
  double chord_error = 0;  ///< largest distance found between a facet or edge and its face or curve
  double volume_error = 0;           ///< relative, of `volume` + `chord_volume`
  std::uint32_t tets_proved = 0;     ///< checked by themselves
  std::uint32_t tets_inherited = 0;  ///< the parent's, unchanged
  /// Tets that differ from the parent's of the same number or have a node elsewhere, ascending;
  /// without a parent all tets.
  std::vector<std::int32_t> changed_tets;

  [[nodiscard]] std::uint32_t count(MeshFailure kind) const {
    return counts[static_cast<std::size_t>(kind)];
  }
};

struct VerifyOptions {
  double volume_tolerance = 0.002;         ///< relative
  InsideTest material;                     ///< of the model; empty: OutsideTet is not checked
  const VerifiedParent* parent = nullptr;  ///< whose proof unchanged tets inherit
  std::uint32_t most_failures = 20;        ///< of each kind, described; all are counted
};

/// For people: whether it is valid, what it counted, and the first failures.
std::string to_text(const Verification& verification);

/// Checks a mesh against the model that it is to represent: positive tets in the material, each
/// once, a closed manifold boundary (by facets, edges and nodes), every model vertex, edge and face
/// there, every boundary facet on its face, no node unused, and the volume within its tolerance of
/// the exact one. What flat facets cut off curved faces is no defect, however coarse the mesh,
/// while they stay within `kChordShare`: it is integrated and added to the volume, and areas are
/// compared within the error that the facets' size allows.
///
/// With a parent, unchanged tets are taken to be positive and in the material, as the parent's are,
/// and facets, boundary edges and fans are checked only at the nodes of tets that came or went. The
/// model may differ from the parent's, so all of the boundary is checked against it. The verdict is
/// the same as without a parent.
///
/// A defect of the mesh is a value here. Throws Cancelled only.
Verification verify(const PagedMesh& mesh, const CowVector<Support>& supports,
                    const BoundaryModel& boundary, double exact_volume, const Run& run,
                    const VerifyOptions& options = {});
/// The same for a mesh that is still worked on.
Verification verify(const TetMesh& mesh, std::span<const Support> supports,
                    const BoundaryModel& boundary, double exact_volume, const Run& run,
                    const VerifyOptions& options = {});

}  // namespace remeshd
