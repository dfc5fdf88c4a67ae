// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace remeshd::client {

/// Where a node of a mesh comes from: not in the original mesh, copied and still at its place there
/// under its source feature's transformation to the bit, or copied and then moved.
enum class NodeOrigin : std::uint8_t { New = 0, Kept = 1, Moved = 2 };

/// A boundary facet: its nodes (normal outward), the tet behind it and its set of model faces.
struct Facet {
  std::array<std::int32_t, 3> nodes{};
  std::int32_t tet = -1;
  std::int32_t group = -1;                       ///< index into `Mesh::facet_groups`
  std::array<std::int32_t, 3> mids{-1, -1, -1};  ///< of second order: of the edges 01 12 20

  friend bool operator==(const Facet&, const Facet&) = default;
};

/// A mesh as the daemon delivers it, with the names on it and the way back to the original mesh.
///
/// Inv: indices are 0-based; every tet (a, b, c, d) has positive volume, dot(cross(b - a, c - a),
/// d - a) > 0. A first mesh has only new nodes and no kept tet. What was not asked for is empty, or
/// -1 in a facet.
struct Mesh {
  std::string revision;  ///< id
  std::string parent;    ///< id of the original mesh's revision; empty for a first mesh
  std::string model_name;
  std::string unit;     ///< of lengths, as the model labels it
  std::string options;  ///< that the mesh was made with, as JSON on one line
  std::uint32_t algorithm_version = 0;

  std::vector<std::array<double, 3>> nodes;  ///< x, y, z in the model's unit
  std::vector<std::array<std::int32_t, 4>> tets;
  std::vector<std::uint64_t> node_ids;  ///< permanent: a kept node keeps its id through edits
  std::vector<std::uint64_t> tet_ids;

  std::vector<Facet> facets;
  std::vector<std::vector<std::string>> facet_groups;  ///< `hole1.wall`, latest owner first
  std::vector<std::int32_t> tet_cell;                  ///< index into `cell_owners` for each tet
  std::vector<std::vector<std::string>> cell_owners;   ///< feature ids in history order

  // Groups of the model; empty where it has none.
  std::vector<std::string> group_names;
  std::vector<std::array<std::int32_t, 2>> group_facets;  ///< group and facet, ascending
  std::vector<std::array<std::int32_t, 2>> group_tets;    ///< group and tet, ascending

  std::vector<NodeOrigin> node_origin;
  std::vector<std::int32_t> original_node;   ///< in the original mesh; -1 where New
  std::vector<std::int32_t> node_transform;  ///< index into `transforms`; -1 where New
  std::vector<std::int32_t> original_tet;    ///< in the original mesh; -1 where not kept
  /// The edge length aimed at, for each node; empty where it is the same everywhere.
  std::vector<double> node_sizes;
  /// Rows of 3x4 matrices. A kept node is the original one times its matrix, row by row, left to
  /// right, without fused operations; the identity copies bits.
  std::vector<std::array<double, 12>> transforms;
  std::vector<std::string> transform_features;  ///< the first source feature of each transform

  // Second order; empty in a mesh of first. Mid-nodes are counted by themselves, from 0.
  std::vector<std::array<double, 3>> mid_nodes;        ///< x, y, z in the model's unit
  std::vector<std::array<std::int32_t, 2>> edge_mids;  ///< by mid-node: corner nodes of its edge
  /// By tet: mid-nodes of the edges 01 12 20 03 13 23, the order of VTK and Abaqus.
  std::vector<std::array<std::int32_t, 6>> tet_mids;
  std::vector<std::uint64_t> mid_node_ids;
  std::vector<NodeOrigin> mid_node_origin;
  std::vector<std::int32_t> original_mid_node;
  std::vector<std::int32_t> mid_node_transform;

  friend bool operator==(const Mesh&, const Mesh&) = default;
};

}  // namespace remeshd::client
