#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "engine/mesh/tet_mesh.h"
#include "remeshd/mesh.h"

namespace remeshd::client {

/// The six tets of each of the brick's cubes.
inline void add_tets_of_brick(int n, Mesh& mesh) {
  const auto node = [n](int x, int y, int z) { return (x * (n + 1) + y) * (n + 1) + z; };
  // Mirrored in z: the corners of every tet are exchanged so that its volume is positive.
  constexpr std::array<std::array<int, 3>, 6> kOrders{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        for (std::size_t k = 0; k < 6; ++k) {
          std::array<int, 3> at{x, y, z};
          std::array<std::int32_t, 4> tet{};
          tet[0] = node(x, y, z);
          for (std::size_t step = 0; step < 3; ++step) {
            ++at[static_cast<std::size_t>(kOrders[k][step])];
            tet[step + 1] = node(at[0], at[1], at[2]);
          }
          const bool even = k == 0 || k == 3 || k == 4;
          if (even) std::swap(tet[2], tet[3]);
          mesh.tets.push_back(tet);
          mesh.tet_cell.push_back(x);
        }
}

/// The facets on the brick's sides. Groups: x = 0, x = 2, y = 0, y = n, z = 0, z = n.
inline void add_facets_of_brick(int n, Mesh& mesh) {
  const std::array<int, 3> last{2, n, n};
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (const auto& side : kTetFacets) {
      Facet facet;
      facet.tet = static_cast<std::int32_t>(t);
      std::array<std::array<int, 3>, 3> grid{};
      for (std::size_t k = 0; k < 3; ++k) {
        facet.nodes[k] = mesh.tets[t][static_cast<std::size_t>(side[k])];
        const int index = facet.nodes[k];
        grid[k] = {index / ((n + 1) * (n + 1)), index / (n + 1) % (n + 1), index % (n + 1)};
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
          if (std::ranges::all_of(
                  grid, [&](const auto& g) { return g[axis] == (end == 0 ? 0 : last[axis]); }))
            facet.group = static_cast<std::int32_t>(2 * axis) + end;
      if (facet.group >= 0) mesh.facets.push_back(facet);
    }
  }
}

/// A brick of 2 x n x n unit cubes, six tets each, with a valid value in every field: the half
/// x < 1 belongs to `base`, the other to `base` and `Slot1`; faces are named after both where they
/// coincide. Coordinates are such that only a full round trip keeps their bits.
inline Mesh sample_mesh(int n) {
  Mesh mesh;
  const auto awkward = [](int k) {
    if (k == 0) return 3.0616169978683824e-17;  // 1/2 cos 90 degrees and the like
    return k * 0.9 + std::sin(k) * 1e-3;
  };
  for (int x = 0; x <= 2; ++x)
    for (int y = 0; y <= n; ++y)
      for (int z = 0; z <= n; ++z)
        mesh.nodes.push_back({awkward(x), z == 0 && y == 0 ? -0.0 : awkward(y), -awkward(z) / 3});
  add_tets_of_brick(n, mesh);
  add_facets_of_brick(n, mesh);
  mesh.cell_owners = {{"base"}, {"base", "Slot1"}};
  mesh.facet_groups = {{"base.x_min"}, {"Slot1.x_max", "base.x_max"},
                       {"base.y_min"}, {"base.y_max"},
                       {"base.top"},   {"Slot1.top", "base.top"}};
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k) {
    const auto index = static_cast<std::int32_t>(k);
    mesh.node_ids.push_back((std::uint64_t{1} << 62) + 3 * k);
    mesh.node_origin.push_back(static_cast<NodeOrigin>(k % 3));
    mesh.original_node.push_back(k % 3 == 0 ? -1 : 2 * index);
    mesh.node_sizes.push_back(0.9 + static_cast<double>(k) / 7);
    mesh.node_transform.push_back(k % 3 == 0 ? -1 : static_cast<std::int32_t>(k % 2));
  }
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    mesh.tet_ids.push_back(std::numeric_limits<std::uint64_t>::max() - t);
    mesh.original_tet.push_back(t % 4 == 0 ? static_cast<std::int32_t>(7 * t) : -1);
  }
  mesh.transforms = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0},
                     {0, -1, 0, 0.1, 1, 0, 0, 0.2, 0, 0, 1, -1.0 / 3}};
  mesh.transform_features = {"base", "Slot1"};
  return mesh;
}

/// The same mesh with groups of the model: a part of a face, material with a face, and nothing; and
/// with what files tell of where it comes from.
inline Mesh with_groups(Mesh mesh) {
  mesh.group_names = {"load", "part", "nothing"};
  const auto size = [](const auto& list) { return static_cast<std::int32_t>(list.size()); };
  for (std::int32_t f = 0; f < size(mesh.facets); ++f)
    if (mesh.facets[static_cast<std::size_t>(f)].group >= 4 && f % 3 == 0)
      mesh.group_facets.push_back({0, f});
  for (std::int32_t f = 0; f < size(mesh.facets); ++f)
    if (mesh.facets[static_cast<std::size_t>(f)].group == 0) mesh.group_facets.push_back({1, f});
  for (std::int32_t t = 0; t < size(mesh.tets); t += 5) mesh.group_tets.push_back({1, t});
  mesh.revision = "0123abcd";
  mesh.parent = "4567ef";
  mesh.model_name = "brick -- of cubes";
  mesh.unit = "mm";
  mesh.options = "{\"nodes\": 27}";
  mesh.algorithm_version = 20;
  return mesh;
}

/// The same mesh with a node on each edge, beside its middle, and a valid value in every field.
inline Mesh with_mid_nodes(Mesh mesh) {
  std::map<std::array<std::int32_t, 2>, std::int32_t> known;
  const auto mid_of = [&](std::int32_t a, std::int32_t b) {
    const std::array<std::int32_t, 2> edge{std::min(a, b), std::max(a, b)};
    const auto next = static_cast<std::int32_t>(known.size());
    const auto [entry, added] = known.emplace(edge, next);
    if (added) {
      const auto &p = mesh.nodes[static_cast<std::size_t>(a)],
                 &q = mesh.nodes[static_cast<std::size_t>(b)];
      mesh.edge_mids.push_back(edge);
      mesh.mid_nodes.push_back({0.5 * (p[0] + q[0]) + 1e-3 / 7, 0.5 * (p[1] + q[1]) - 1e-3 / 3,
                                0.5 * (p[2] + q[2]) + 1e-3 / 9});
    }
    return entry->second;
  };
  for (const auto& tet : mesh.tets) {
    auto& mids = mesh.tet_mids.emplace_back();
    for (std::size_t k = 0; k < 6; ++k)
      mids[k] = mid_of(tet[static_cast<std::size_t>(kTetEdges[k][0])],
                       tet[static_cast<std::size_t>(kTetEdges[k][1])]);
  }
  for (Facet& facet : mesh.facets)
    for (std::size_t k = 0; k < 3; ++k)
      facet.mids[k] = mid_of(facet.nodes[k], facet.nodes[(k + 1) % 3]);
  for (std::size_t k = 0; k < mesh.mid_nodes.size(); ++k) {
    mesh.mid_node_ids.push_back((std::uint64_t{1} << 61) + 5 * k);
    mesh.mid_node_origin.push_back(static_cast<NodeOrigin>(k % 3));
    mesh.original_mid_node.push_back(k % 3 == 0 ? -1 : static_cast<std::int32_t>(3 * k));
    mesh.mid_node_transform.push_back(k % 3 == 0 ? -1 : static_cast<std::int32_t>(k % 2));
  }
  return mesh;
}

}  // namespace remeshd::client
