// SPDX-License-Identifier: Apache-2.0
#include "client/library/check_mesh.h"

#include "client/library/mesh_damaged.h"

namespace remeshd::client {
namespace {

using remesh::v1::MeshArray;

void check_index(std::int64_t index, std::int64_t low, std::size_t size, MeshArray array) {
  if (index < low || index >= static_cast<std::int64_t>(size))
    mesh_damaged(name_of(array) + " has an index out of range");
}

/// Checks that a facet is one of its tet: exactly one corner of the tet is not the facet's, on
/// which the file formats rely.
void check_facets_tet(const Facet& facet, const Mesh& mesh) {
  int shared = 0;
  for (const std::int32_t corner : mesh.tets[static_cast<std::size_t>(facet.tet)])
    for (const std::int32_t node : facet.nodes) shared += corner == node ? 1 : 0;
  if (shared != 3) mesh_damaged("a facet is not one of its tet");
}

void check_mids(const Mesh& mesh, const std::set<MeshArray>& arrays) {
  using namespace remesh::v1;  // NOLINT(google-build-using-namespace): names of arrays
  const auto has = [&](auto... wanted) { return (arrays.contains(wanted) && ...); };
  if (has(MESH_ARRAY_EDGE_MIDS, MESH_ARRAY_NODES))
    for (const auto& corners : mesh.edge_mids)
      for (const std::int32_t node : corners)
        check_index(node, 0, mesh.nodes.size(), MESH_ARRAY_EDGE_MIDS);
  if (has(MESH_ARRAY_TET_MIDS, MESH_ARRAY_MID_NODES))
    for (const auto& mids : mesh.tet_mids)
      for (const std::int32_t mid : mids)
        check_index(mid, 0, mesh.mid_nodes.size(), MESH_ARRAY_TET_MIDS);
  if (has(MESH_ARRAY_FACET_MIDS, MESH_ARRAY_MID_NODES))
    for (const Facet& facet : mesh.facets)
      for (const std::int32_t mid : facet.mids)
        check_index(mid, 0, mesh.mid_nodes.size(), MESH_ARRAY_FACET_MIDS);
  if (has(MESH_ARRAY_MID_NODE_TRANSFORMS, MESH_ARRAY_TRANSFORMS))
    for (const std::int32_t transform : mesh.mid_node_transform)
      check_index(transform, -1, mesh.transforms.size(), MESH_ARRAY_MID_NODE_TRANSFORMS);
  for (const NodeOrigin origin : mesh.mid_node_origin)
    check_index(static_cast<std::int64_t>(origin), 0, 3, MESH_ARRAY_MID_NODE_ORIGINS);
}

void check_members(const std::vector<std::array<std::int32_t, 2>>& members, std::size_t groups,
                   std::size_t size, MeshArray array) {
  for (const auto& [group, member] : members) {
    check_index(group, 0, groups, array);
    check_index(member, 0, size, array);
  }
}

void check_groups(const Mesh& mesh, const std::set<MeshArray>& arrays) {
  using namespace remesh::v1;  // NOLINT(google-build-using-namespace): names of arrays
  const auto has = [&](auto... wanted) { return (arrays.contains(wanted) && ...); };
  if (has(MESH_ARRAY_GROUP_NAMES, MESH_ARRAY_GROUP_FACETS, MESH_ARRAY_FACETS))
    check_members(mesh.group_facets, mesh.group_names.size(), mesh.facets.size(),
                  MESH_ARRAY_GROUP_FACETS);
  if (has(MESH_ARRAY_GROUP_NAMES, MESH_ARRAY_GROUP_TETS, MESH_ARRAY_TETS))
    check_members(mesh.group_tets, mesh.group_names.size(), mesh.tets.size(),
                  MESH_ARRAY_GROUP_TETS);
}

}  // namespace

void check_mesh(const Mesh& mesh, const std::set<MeshArray>& arrays) {
  using namespace remesh::v1;  // NOLINT(google-build-using-namespace): names of arrays
  const auto has = [&](auto... wanted) { return (arrays.contains(wanted) && ...); };
  if (has(MESH_ARRAY_TETS, MESH_ARRAY_NODES))
    for (const auto& tet : mesh.tets)
      for (const std::int32_t node : tet) check_index(node, 0, mesh.nodes.size(), MESH_ARRAY_TETS);
  if (has(MESH_ARRAY_FACETS, MESH_ARRAY_NODES))
    for (const Facet& facet : mesh.facets)
      for (const std::int32_t node : facet.nodes)
        check_index(node, 0, mesh.nodes.size(), MESH_ARRAY_FACETS);
  if (has(MESH_ARRAY_FACET_TETS, MESH_ARRAY_TETS))
    for (const Facet& facet : mesh.facets)
      check_index(facet.tet, 0, mesh.tets.size(), MESH_ARRAY_FACET_TETS);
  if (has(MESH_ARRAY_FACETS, MESH_ARRAY_FACET_TETS, MESH_ARRAY_TETS))
    for (const Facet& facet : mesh.facets) check_facets_tet(facet, mesh);
  if (has(MESH_ARRAY_FACET_GROUP, MESH_ARRAY_FACET_GROUPS))
    for (const Facet& facet : mesh.facets)
      check_index(facet.group, 0, mesh.facet_groups.size(), MESH_ARRAY_FACET_GROUP);
  if (has(MESH_ARRAY_TET_CELLS, MESH_ARRAY_CELL_OWNERS))
    for (const std::int32_t cell : mesh.tet_cell)
      check_index(cell, 0, mesh.cell_owners.size(), MESH_ARRAY_TET_CELLS);
  if (has(MESH_ARRAY_NODE_TRANSFORMS, MESH_ARRAY_TRANSFORMS))
    for (const std::int32_t transform : mesh.node_transform)
      check_index(transform, -1, mesh.transforms.size(), MESH_ARRAY_NODE_TRANSFORMS);
  for (const NodeOrigin origin : mesh.node_origin)
    check_index(static_cast<std::int64_t>(origin), 0, 3, MESH_ARRAY_NODE_ORIGINS);
  check_groups(mesh, arrays);
  check_mids(mesh, arrays);
}

}  // namespace remeshd::client
