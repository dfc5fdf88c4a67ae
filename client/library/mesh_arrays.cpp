// SPDX-License-Identifier: Apache-2.0
#include "client/library/mesh_arrays.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

#include "client/library/mesh_damaged.h"

namespace remeshd::client {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are copied as they lie");
static_assert(sizeof(NodeOrigin) == 1);

using Names = std::vector<std::string>;

template <auto kMember>
void read_numbers(std::string_view bytes, Mesh& mesh) {
  auto& values = mesh.*kMember;
  values.resize(bytes.size() / sizeof values[0]);
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
}

template <auto kMember>
std::string write_numbers(const Mesh& mesh) {
  const auto& values = mesh.*kMember;
  if (values.empty()) return {};
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof values[0]};
}

/// One field of the facets, which a Mesh keeps together.
template <auto kField>
void read_facets(std::string_view bytes, Mesh& mesh) {
  constexpr std::size_t kBytes = sizeof(Facet{}.*kField);
  mesh.facets.resize(bytes.size() / kBytes);
  for (std::size_t k = 0; k < mesh.facets.size(); ++k)
    std::memcpy(&(mesh.facets[k].*kField), bytes.data() + k * kBytes, kBytes);
}

template <auto kField>
std::string write_facets(const Mesh& mesh) {
  std::string bytes;
  for (const Facet& facet : mesh.facets)
    bytes.append(reinterpret_cast<const char*>(&(facet.*kField)), sizeof(facet.*kField));
  return bytes;
}

Names names_of(std::string_view line) {
  Names names;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find(' ', at), line.size());
    names.emplace_back(line.substr(at, end - at));
    at = end + 1;
  }
  return names;
}

template <auto kMember>
void read_lines(std::string_view bytes, Mesh& mesh) {
  auto& lines = mesh.*kMember;
  lines.clear();
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string_view::npos) mesh_damaged("a text ends within a line");
    const std::string_view line = bytes.substr(at, end - at);
    if constexpr (std::is_same_v<std::decay_t<decltype(lines)>, Names>)
      lines.emplace_back(line);
    else
      lines.push_back(names_of(line));
    at = end + 1;
  }
}

std::string joined(const Names& names) {
  std::string line;
  for (const std::string& name : names) line += (line.empty() ? "" : " ") + name;
  return line;
}
const std::string& joined(const std::string& line) { return line; }

template <auto kMember>
std::string write_lines(const Mesh& mesh) {
  std::string bytes;
  for (const auto& line : mesh.*kMember) bytes += joined(line) + "\n";
  return bytes;
}

template <auto kMember>
constexpr KnownArray numbers(remesh::v1::MeshArray array, RowOf row_of, remesh::v1::ArrayType type,
                             std::uint32_t components = 1) {
  return {array, {type, components}, row_of, read_numbers<kMember>, write_numbers<kMember>};
}

template <auto kField>
constexpr KnownArray facets(remesh::v1::MeshArray array, std::uint32_t components = 1) {
  return {array,
          {remesh::v1::ARRAY_TYPE_I32, components},
          RowOf::Facet,
          read_facets<kField>,
          write_facets<kField>};
}

template <auto kMember>
constexpr KnownArray text(remesh::v1::MeshArray array) {
  return {array,
          {remesh::v1::ARRAY_TYPE_TEXT, 1},
          RowOf::Other,
          read_lines<kMember>,
          write_lines<kMember>};
}

using remesh::v1::ARRAY_TYPE_F64;
using remesh::v1::ARRAY_TYPE_I32;
using remesh::v1::ARRAY_TYPE_U64;
using remesh::v1::ARRAY_TYPE_U8;

constexpr std::array kKnown{
    numbers<&Mesh::nodes>(remesh::v1::MESH_ARRAY_NODES, RowOf::Node, ARRAY_TYPE_F64, 3),
    numbers<&Mesh::tets>(remesh::v1::MESH_ARRAY_TETS, RowOf::Tet, ARRAY_TYPE_I32, 4),
    numbers<&Mesh::node_ids>(remesh::v1::MESH_ARRAY_NODE_IDS, RowOf::Node, ARRAY_TYPE_U64),
    numbers<&Mesh::tet_ids>(remesh::v1::MESH_ARRAY_TET_IDS, RowOf::Tet, ARRAY_TYPE_U64),
    facets<&Facet::nodes>(remesh::v1::MESH_ARRAY_FACETS, 3),
    facets<&Facet::tet>(remesh::v1::MESH_ARRAY_FACET_TETS),
    facets<&Facet::group>(remesh::v1::MESH_ARRAY_FACET_GROUP),
    text<&Mesh::facet_groups>(remesh::v1::MESH_ARRAY_FACET_GROUPS),
    numbers<&Mesh::tet_cell>(remesh::v1::MESH_ARRAY_TET_CELLS, RowOf::Tet, ARRAY_TYPE_I32),
    text<&Mesh::cell_owners>(remesh::v1::MESH_ARRAY_CELL_OWNERS),
    numbers<&Mesh::node_origin>(remesh::v1::MESH_ARRAY_NODE_ORIGINS, RowOf::Node, ARRAY_TYPE_U8),
    numbers<&Mesh::original_node>(remesh::v1::MESH_ARRAY_ORIGINAL_NODES, RowOf::Node,
                                  ARRAY_TYPE_I32),
    numbers<&Mesh::node_transform>(remesh::v1::MESH_ARRAY_NODE_TRANSFORMS, RowOf::Node,
                                   ARRAY_TYPE_I32),
    numbers<&Mesh::transforms>(remesh::v1::MESH_ARRAY_TRANSFORMS, RowOf::Other, ARRAY_TYPE_F64, 12),
    text<&Mesh::transform_features>(remesh::v1::MESH_ARRAY_TRANSFORM_FEATURES),
    numbers<&Mesh::original_tet>(remesh::v1::MESH_ARRAY_ORIGINAL_TETS, RowOf::Tet, ARRAY_TYPE_I32),
    text<&Mesh::group_names>(remesh::v1::MESH_ARRAY_GROUP_NAMES),
    numbers<&Mesh::group_facets>(remesh::v1::MESH_ARRAY_GROUP_FACETS, RowOf::Other, ARRAY_TYPE_I32,
                                 2),
    numbers<&Mesh::group_tets>(remesh::v1::MESH_ARRAY_GROUP_TETS, RowOf::Other, ARRAY_TYPE_I32, 2),
    numbers<&Mesh::node_sizes>(remesh::v1::MESH_ARRAY_NODE_SIZES, RowOf::Node, ARRAY_TYPE_F64),
    numbers<&Mesh::mid_nodes>(remesh::v1::MESH_ARRAY_MID_NODES, RowOf::MidNode, ARRAY_TYPE_F64, 3),
    numbers<&Mesh::edge_mids>(remesh::v1::MESH_ARRAY_EDGE_MIDS, RowOf::MidNode, ARRAY_TYPE_I32, 2),
    numbers<&Mesh::tet_mids>(remesh::v1::MESH_ARRAY_TET_MIDS, RowOf::Tet, ARRAY_TYPE_I32, 6),
    facets<&Facet::mids>(remesh::v1::MESH_ARRAY_FACET_MIDS, 3),
    numbers<&Mesh::mid_node_ids>(remesh::v1::MESH_ARRAY_MID_NODE_IDS, RowOf::MidNode,
                                 ARRAY_TYPE_U64),
    numbers<&Mesh::mid_node_origin>(remesh::v1::MESH_ARRAY_MID_NODE_ORIGINS, RowOf::MidNode,
                                    ARRAY_TYPE_U8),
    numbers<&Mesh::original_mid_node>(remesh::v1::MESH_ARRAY_ORIGINAL_MID_NODES, RowOf::MidNode,
                                      ARRAY_TYPE_I32),
    numbers<&Mesh::mid_node_transform>(remesh::v1::MESH_ARRAY_MID_NODE_TRANSFORMS, RowOf::MidNode,
                                       ARRAY_TYPE_I32),
};

}  // namespace

std::span<const KnownArray> known_arrays() { return kKnown; }

const KnownArray* find_array(remesh::v1::MeshArray array) {
  const auto found = std::ranges::find(kKnown, array, &KnownArray::array);
  return found == kKnown.end() ? nullptr : &*found;
}

}  // namespace remeshd::client
