#include "engine/remesh/node_map.h"

#include <algorithm>

namespace remeshd {

NodeMap map_to_nothing(const TetMesh& mesh) {
  NodeMap map;
  map.node_origin.assign(mesh.nodes.size(), NodeOrigin::New);
  map.original_node.assign(mesh.nodes.size(), -1);
  map.node_transform.assign(mesh.nodes.size(), -1);
  map.original_tet.assign(mesh.tets.size(), -1);
  return map;
}

NodeMap map_kept(const Revision& original, std::span<const Vec3> nodes) {
  NodeMap map;
  map.transforms = {Transform{}};
  map.transform_features = {original.model.features.front().id};
  const TetMesh& then = original.delivery.mesh;
  map.node_transform.assign(then.nodes.size(), 0);
  map.node_origin.reserve(then.nodes.size());
  map.original_node.reserve(then.nodes.size());
  map.original_tet.reserve(then.tets.size());
  for (std::size_t n = 0; n < then.nodes.size(); ++n) {
    map.node_origin.push_back(nodes[n] == then.nodes[n] ? NodeOrigin::Kept : NodeOrigin::Moved);
    map.original_node.push_back(static_cast<std::int32_t>(n));
  }
  for (std::size_t t = 0; t < then.tets.size(); ++t) {
    const Tet& tet = then.tets[t];
    const bool kept = std::all_of(tet.begin(), tet.end(), [&](std::int32_t n) {
      return map.node_origin[n] == NodeOrigin::Kept;
    });
    map.original_tet.push_back(kept ? static_cast<std::int32_t>(t) : -1);
  }
  return map;
}

VerifiedParent verified_parent(const Revision& original, std::span<const std::int32_t> node,
                               std::span<const std::int32_t> tet) {
  const Delivery& d = original.delivery;
  VerifiedParent parent{{d.mesh.nodes, d.mesh.tets}, {}, original.report.volume, node, tet};
  parent.surface.reserve(d.groups.facets.size());
  for (const MeshFacet& f : d.groups.facets) parent.surface.push_back({f.nodes, f.tet});
  return parent;
}

}  // namespace remeshd
