#include "engine/remesh/finish/faults.h"

#include <algorithm>

#include "engine/mesh/quality.h"

namespace remeshd {

namespace {
template <class Mesh>
bool is_sound(const Mesh& mesh, const Verification& verification) {
  for (const MeshFailure kind :
       {MeshFailure::BadFacet, MeshFailure::NonManifoldEdge, MeshFailure::NonManifoldVertex})
    if (verification.count(kind) > 0) return false;
  return std::ranges::all_of(mesh.tets,
                             [&](const Tet& t) { return volume_length(mesh.nodes, t) >= 0; });
}
}  // namespace

std::vector<MeshDefect> nonconforming_facets(const PeeledMesh& mesh) {
  std::vector<MeshDefect> defects;
  for (const Vec3& place : mesh.nonconforming)
    defects.push_back(
        {MeshFailure::NonconformingFacet, -1, place, "a boundary facet on no model face"});
  return defects;
}

bool boundary_is_complete(const Verification& v) {
  return v.count(MeshFailure::NonManifoldEdge) + v.count(MeshFailure::NonManifoldVertex) +
             v.count(MeshFailure::MissingVertex) + v.count(MeshFailure::MissingSegment) +
             v.count(MeshFailure::NonconformingFacet) + v.count(MeshFailure::FacetOffFace) +
             v.count(MeshFailure::FaceArea) ==
         0;
}

bool can_be_improved(const TetMesh& mesh, const Verification& verification) {
  return is_sound(mesh, verification);
}
bool can_be_improved(const PagedMesh& mesh, const Verification& verification) {
  return is_sound(mesh, verification);
}

}  // namespace remeshd
