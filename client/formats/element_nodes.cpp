// SPDX-License-Identifier: Apache-2.0
#include "client/formats/element_nodes.h"

namespace remeshd::client {
namespace {

template <class Corners, class Mids>
std::vector<std::int32_t> together(const Mesh& mesh, const Corners& corners, const Mids& mids) {
  std::vector<std::int32_t> nodes(corners.begin(), corners.end());
  const auto first = static_cast<std::int32_t>(mesh.nodes.size());
  for (const std::int32_t mid : mids) nodes.push_back(first + mid);
  return nodes;
}

}  // namespace

std::vector<std::int32_t> nodes_of(const Mesh& mesh, std::size_t tet) {
  const auto& corners = mesh.tets[tet];
  if (!is_second_order(mesh)) return {corners.begin(), corners.end()};
  return together(mesh, corners, mesh.tet_mids[tet]);
}

std::vector<std::int32_t> nodes_of(const Mesh& mesh, const Facet& facet) {
  if (!is_second_order(mesh)) return {facet.nodes.begin(), facet.nodes.end()};
  return together(mesh, facet.nodes, facet.mids);
}

std::vector<double> sizes_of(const Mesh& mesh) {
  std::vector<double> sizes = mesh.node_sizes;
  if (sizes.empty()) return sizes;
  for (const auto& [a, b] : mesh.edge_mids)
    sizes.push_back(0.5 * (mesh.node_sizes[static_cast<std::size_t>(a)] +
                           mesh.node_sizes[static_cast<std::size_t>(b)]));
  return sizes;
}

}  // namespace remeshd::client
