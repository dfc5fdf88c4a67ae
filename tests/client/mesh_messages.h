#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "proto/checksum.h"
#include "remesh/v1/remesh.pb.h"
#include "remeshd/mesh.h"
#include "tests/client/encode_delta.h"

namespace remeshd::client {

/// How a mesh is to be sent.
struct Sending {
  std::size_t part_size = 4096;                 ///< bytes
  std::vector<remesh::v1::MeshArray> arrays{};  ///< none: all
  const Mesh* base = nullptr;                   ///< of deltas; null: the mesh comes whole
};

/// An array as it travels.
struct SentArray {
  remesh::v1::MeshArray id;
  remesh::v1::ArrayType type;
  std::uint32_t components;
  std::string bytes;
  std::size_t count;
};

inline std::vector<SentArray> arrays_of(const Mesh& mesh) {
  namespace v1 = remesh::v1;
  const auto raw = [](v1::MeshArray id, v1::ArrayType type, std::uint32_t components,
                      const auto& values) {
    std::string bytes(values.size() * sizeof(values[0]), '\0');
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return SentArray{id, type, components, std::move(bytes), values.size()};
  };
  const auto text = [](v1::MeshArray id, const std::vector<std::vector<std::string>>& lists) {
    std::string bytes;
    for (const auto& list : lists) {
      for (std::size_t k = 0; k < list.size(); ++k) bytes += (k == 0 ? "" : " ") + list[k];
      bytes += "\n";
    }
    return SentArray{id, v1::ARRAY_TYPE_TEXT, 1, bytes, lists.size()};
  };
  std::vector<std::array<std::int32_t, 3>> facets;
  std::vector<std::int32_t> facet_tets, facet_group;
  for (const Facet& facet : mesh.facets) {
    facets.push_back(facet.nodes);
    facet_tets.push_back(facet.tet);
    facet_group.push_back(facet.group);
  }
  std::vector<std::vector<std::string>> sources;
  for (const std::string& feature : mesh.transform_features) sources.push_back({feature});
  constexpr auto kF64 = v1::ARRAY_TYPE_F64, kI32 = v1::ARRAY_TYPE_I32, kU64 = v1::ARRAY_TYPE_U64;
  std::vector<SentArray> arrays{
      raw(v1::MESH_ARRAY_NODES, kF64, 3, mesh.nodes),
      raw(v1::MESH_ARRAY_TETS, kI32, 4, mesh.tets),
      raw(v1::MESH_ARRAY_NODE_IDS, kU64, 1, mesh.node_ids),
      raw(v1::MESH_ARRAY_TET_IDS, kU64, 1, mesh.tet_ids),
      raw(v1::MESH_ARRAY_FACETS, kI32, 3, facets),
      raw(v1::MESH_ARRAY_FACET_TETS, kI32, 1, facet_tets),
      raw(v1::MESH_ARRAY_FACET_GROUP, kI32, 1, facet_group),
      text(v1::MESH_ARRAY_FACET_GROUPS, mesh.facet_groups),
      raw(v1::MESH_ARRAY_TET_CELLS, kI32, 1, mesh.tet_cell),
      text(v1::MESH_ARRAY_CELL_OWNERS, mesh.cell_owners),
      raw(v1::MESH_ARRAY_NODE_ORIGINS, v1::ARRAY_TYPE_U8, 1, mesh.node_origin),
      raw(v1::MESH_ARRAY_ORIGINAL_NODES, kI32, 1, mesh.original_node),
      raw(v1::MESH_ARRAY_NODE_TRANSFORMS, kI32, 1, mesh.node_transform),
      raw(v1::MESH_ARRAY_TRANSFORMS, kF64, 12, mesh.transforms),
      text(v1::MESH_ARRAY_TRANSFORM_FEATURES, sources),
      raw(v1::MESH_ARRAY_ORIGINAL_TETS, kI32, 1, mesh.original_tet)};
  if (!mesh.node_sizes.empty())
    arrays.push_back(raw(v1::MESH_ARRAY_NODE_SIZES, kF64, 1, mesh.node_sizes));
  if (mesh.mid_nodes.empty()) return arrays;
  std::vector<std::array<std::int32_t, 3>> facet_mids;
  for (const Facet& facet : mesh.facets) facet_mids.push_back(facet.mids);
  for (SentArray array :
       {raw(v1::MESH_ARRAY_MID_NODES, kF64, 3, mesh.mid_nodes),
        raw(v1::MESH_ARRAY_EDGE_MIDS, kI32, 2, mesh.edge_mids),
        raw(v1::MESH_ARRAY_TET_MIDS, kI32, 6, mesh.tet_mids),
        raw(v1::MESH_ARRAY_FACET_MIDS, kI32, 3, facet_mids),
        raw(v1::MESH_ARRAY_MID_NODE_IDS, kU64, 1, mesh.mid_node_ids),
        raw(v1::MESH_ARRAY_MID_NODE_ORIGINS, v1::ARRAY_TYPE_U8, 1, mesh.mid_node_origin),
        raw(v1::MESH_ARRAY_ORIGINAL_MID_NODES, kI32, 1, mesh.original_mid_node),
        raw(v1::MESH_ARRAY_MID_NODE_TRANSFORMS, kI32, 1, mesh.mid_node_transform)})
    arrays.push_back(std::move(array));
  return arrays;
}

/// SHA-256 over the SHA-256s of blocks of 16 KiB, in hexadecimal digits.
inline std::string digest_of(const std::string& bytes) {
  std::string sums;
  for (std::size_t at = 0; at < bytes.size(); at += 16384) {
    Sha256 sum;
    sum.update(std::string_view(bytes).substr(at, 16384));
    sums += sum.finish();
  }
  return sha256_hex(sums);
}

/// Puts the data of one array into the header's entry, as a delta or whole; returns what to send.
inline std::string encode(const SentArray& array, const Mesh* base,
                          remesh::v1::MeshHeader::Array& entry) {
  namespace v1 = remesh::v1;
  entry.set_array(array.id);
  entry.set_type(array.type);
  entry.set_components(array.components);
  entry.set_count(static_cast<std::uint32_t>(array.count));
  entry.set_bytes(array.bytes.size());
  entry.set_digest(digest_of(array.bytes));
  std::string data = array.bytes;
  entry.set_encoding(v1::MeshHeader::ENCODING_WHOLE);
  if (base != nullptr) {
    const auto arrays = arrays_of(*base);
    const auto of_base = std::ranges::find(arrays, array.id, &SentArray::id);
    const std::string& old = of_base->bytes;
    if (old == array.bytes) {
      data.clear();
      entry.set_encoding(v1::MeshHeader::ENCODING_SAME);
    } else if (array.type != v1::ARRAY_TYPE_TEXT && array.count > 0) {
      const bool whole_numbers =
          array.type == v1::ARRAY_TYPE_I32 || array.type == v1::ARRAY_TYPE_U64;
      data = encode_delta(array.bytes, old, array.bytes.size() / array.count,
                          whole_numbers && array.components == 1)
                 .SerializeAsString();
      entry.set_encoding(v1::MeshHeader::ENCODING_DELTA);
    }
  }
  entry.set_data_bytes(data.size());
  return data;
}

/// A mesh as the messages that a daemon sends.
inline std::vector<remesh::v1::MeshMessage> mesh_messages(const Mesh& mesh,
                                                          const Sending& sending = {}) {
  std::vector<remesh::v1::MeshMessage> messages(1);
  remesh::v1::MeshHeader header;
  header.set_revision(mesh.revision);
  header.set_parent(mesh.parent);
  if (sending.base != nullptr) header.set_base(sending.base->revision);
  header.set_order(mesh.tet_mids.empty() ? 1 : 2);
  header.set_mid_nodes(static_cast<std::uint32_t>(mesh.mid_nodes.size()));
  header.set_nodes(static_cast<std::uint32_t>(mesh.nodes.size()));
  header.set_tets(static_cast<std::uint32_t>(mesh.tets.size()));
  header.set_facets(static_cast<std::uint32_t>(mesh.facets.size()));
  std::uint64_t bytes = 0;
  for (const SentArray& array : arrays_of(mesh)) {
    if (!sending.arrays.empty() && std::ranges::count(sending.arrays, array.id) == 0) continue;
    const std::string data = encode(array, sending.base, *header.add_arrays());
    bytes += data.size();
    for (std::size_t at = 0; at < data.size(); at += sending.part_size) {
      auto* part = messages.emplace_back().mutable_part();
      part->set_array(array.id);
      part->set_offset(at);
      part->set_data(data.substr(at, sending.part_size));
      part->set_crc32c(crc32c(part->data()));
    }
  }
  *messages[0].mutable_header() = header;
  const auto parts = static_cast<std::uint32_t>(messages.size() - 1);
  auto* end = messages.emplace_back().mutable_end();
  end->set_bytes(bytes);
  end->set_parts(parts);
  return messages;
}

/// Leaves out the parts before a position, as the daemon does.
inline void drop_before(const remesh::v1::MeshPosition& position,
                        std::vector<remesh::v1::MeshMessage>& messages) {
  bool met = false, behind = false;
  std::erase_if(messages, [&](const remesh::v1::MeshMessage& message) {
    if (!message.has_part()) return false;
    const bool in_array = message.part().array() == position.array();
    behind =
        behind || (met && !in_array) || (in_array && message.part().offset() >= position.offset());
    met = met || in_array;
    return !behind;
  });
  auto& end = *messages.back().mutable_end();
  end.set_parts(static_cast<std::uint32_t>(messages.size() - 2));
  end.set_bytes(0);
  for (const auto& message : messages) end.set_bytes(end.bytes() + message.part().data().size());
}

}  // namespace remeshd::client
