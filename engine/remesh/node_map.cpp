#include "engine/remesh/node_map.h"

#include <algorithm>

#include "engine/remesh/tet_index.h"

namespace remeshd {

NodeMap map_to_nothing(const TetMesh& mesh) {
  NodeMap map;
  map.node_origin.assign(mesh.nodes.size(), NodeOrigin::New);
  map.original_node.assign(mesh.nodes.size(), -1);
  map.node_transform.assign(mesh.nodes.size(), -1);
  map.original_tet.assign(mesh.tets.size(), -1);
  return map;
}

NodeMap map_to(const Revision& original, const NodeSet& nodes, const TetMesh& mesh,
               const PointSource& source, const Run& run) {
  NodeMap map = map_to_nothing(mesh);
  map.transforms = source.transforms();
  map.transform_features.resize(map.transforms.size());
  for (const SourceFeature& s : source.sources())
    if (map.transform_features[s.transform].empty())
      map.transform_features[s.transform] = original.model.features[s.original].id;
  const TetMesh& then = original.delivery.mesh;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const std::int32_t o = nodes.original[n];
    if (o < 0 || static_cast<std::size_t>(o) >= then.nodes.size()) continue;
    const Vec3 copied = source.transforms()[nodes.transform[n]].apply(then.nodes[o]);
    map.node_origin[n] = mesh.nodes[n] == copied ? NodeOrigin::Kept : NodeOrigin::Moved;
    map.original_node[n] = o;
    map.node_transform[n] = nodes.transform[n];
  }
  Polling poll(run);
  const TetIndex index(then.tets, then.nodes.size(), poll);
  for (std::size_t k = 0; k < mesh.tets.size(); ++k) {
    poll();
    const Tet& t = mesh.tets[k];
    const bool kept = std::all_of(t.begin(), t.end(), [&](std::int32_t n) {
      return map.node_origin[n] == NodeOrigin::Kept &&
             map.node_transform[n] == map.node_transform[t[0]];
    });
    if (kept)
      map.original_tet[k] = index.find({map.original_node[t[0]], map.original_node[t[1]],
                                        map.original_node[t[2]], map.original_node[t[3]]});
  }
  return map;
}

NodeMap map_kept(const Revision& original, std::span<const Vec3> nodes) {
  NodeMap map;
  map.transforms = {Transform{}};
  map.transform_features = {original.model.features.front().id};
  const TetMesh& then = original.delivery.mesh;
  map.node_transform.assign(then.nodes.size(), 0);
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
