#include "engine/patch/node_map.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace remeshd {

namespace {

/// Makes each element its own index; pages where that is so already stay shared.
void count_up(CowVector<std::int32_t>& values, std::size_t size) {
  values.resize(size);
  for (std::size_t begin = 0; begin < size; begin += values.kPage) {
    const std::span<const std::int32_t> page = values.page(begin / values.kPage);
    std::size_t differ = 0;
    for (std::size_t k = 0; k < page.size(); ++k)
      differ += page[k] != static_cast<std::int32_t>(begin + k) ? 1 : 0;
    if (differ == 0) continue;
    const std::span<std::int32_t> own = values.edit_page(begin / values.kPage);
    std::iota(own.begin(), own.end(), static_cast<std::int32_t>(begin));
  }
}

}  // namespace

NodeMap map_to_itself(const Revision& original, const CowVector<Vec3>& nodes,
                      std::int32_t identity) {
  const OutputMesh& then = original.output;
  // Begins with the original's own map, to share pages: much of it is the same after an edit.
  NodeMap map{.node_origin = then.map.node_origin,
              .original_node = then.map.original_node,
              .node_transform = then.map.node_transform,
              .original_tet = then.map.original_tet};
  count_up(map.original_node, nodes.size());
  count_up(map.original_tet, then.mesh.tets.size());
  bool moved = false;
  nodes.for_each([&](std::size_t n, const Vec3& p) {
    const bool kept = p == then.mesh.nodes[n];
    moved = moved || !kept;
    map.node_origin.set(n, kept ? NodeOrigin::Kept : NodeOrigin::Moved);
    map.node_transform.set(n, identity);
  });
  if (!moved) return map;
  then.mesh.tets.for_each([&](std::size_t t, const Tet& tet) {
    if (std::ranges::any_of(tet,
                            [&](std::int32_t n) { return map.node_origin[n] != NodeOrigin::Kept; }))
      map.original_tet.edit(t) = -1;
  });
  return map;
}

NodeMap map_kept(const Revision& original, const CowVector<Vec3>& nodes) {
  NodeMap map = map_to_itself(original, nodes, 0);
  map.transforms = {Transform{}};
  map.transform_features = {original.model.features.front().id};
  return map;
}

VerifiedParent verified_parent(const Revision& original) {
  CowVector<std::int32_t> node = original.output.map.original_node;
  CowVector<std::int32_t> tet = original.output.map.original_tet;
  count_up(node, original.output.mesh.nodes.size());
  count_up(tet, original.output.mesh.tets.size());
  return verified_parent(original, node, tet);
}

VerifiedParent verified_parent(const Revision& original, const CowVector<std::int32_t>& node,
                               const CowVector<std::int32_t>& tet) {
  const OutputMesh& d = original.output;
  VerifiedParent parent{d.mesh, original.boxes, {}, original.report.volume, node, tet};
  parent.surface.reserve(d.groups.facets.size());
  for (const MeshFacet& f : d.groups.facets) parent.surface.push_back({f.nodes, f.tet});
  return parent;
}

}  // namespace remeshd
