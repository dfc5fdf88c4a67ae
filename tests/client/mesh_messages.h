#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "proto/checksum.h"
#include "remesh/v1/remesh.pb.h"
#include "remeshd/mesh.h"

namespace remeshd::client {

/// A mesh as the messages of a GetMesh stream, in parts of `part_size` bytes.
inline std::vector<remesh::v1::MeshMessage> mesh_messages(const Mesh& mesh, std::size_t part_size) {
  namespace v1 = remesh::v1;
  struct Array {
    v1::MeshArray id;
    std::string bytes;
    std::size_t count;
  };
  const auto raw = [](v1::MeshArray id, const auto& values) {
    std::string bytes(values.size() * sizeof(values[0]), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return Array{id, std::move(bytes), values.size()};
  };
  const auto text = [](v1::MeshArray id, const std::vector<std::vector<std::string>>& lists) {
    std::string bytes;
    for (const auto& list : lists) {
      for (std::size_t k = 0; k < list.size(); ++k) bytes += (k == 0 ? "" : " ") + list[k];
      bytes += "\n";
    }
    return Array{id, bytes, lists.size()};
  };
  std::vector<std::vector<std::string>> sources;
  for (const std::string& feature : mesh.transform_features) sources.push_back({feature});
  const std::vector<Array> arrays{raw(v1::NODES, mesh.nodes),
                                  raw(v1::TETS, mesh.tets),
                                  raw(v1::NODE_IDS, mesh.node_ids),
                                  raw(v1::TET_IDS, mesh.tet_ids),
                                  raw(v1::FACETS, mesh.facets),
                                  text(v1::FACET_GROUPS, mesh.facet_groups),
                                  raw(v1::TET_CELLS, mesh.tet_cell),
                                  text(v1::CELL_OWNERS, mesh.cell_owners),
                                  raw(v1::NODE_ORIGINS, mesh.node_origin),
                                  raw(v1::ORIGINAL_NODES, mesh.original_node),
                                  raw(v1::NODE_TRANSFORMS, mesh.node_transform),
                                  raw(v1::TRANSFORMS, mesh.transforms),
                                  text(v1::TRANSFORM_FEATURES, sources),
                                  raw(v1::ORIGINAL_TETS, mesh.original_tet)};

  std::vector<v1::MeshMessage> messages(1);
  auto* header = messages[0].mutable_header();
  header->set_revision("r");
  header->set_nodes(static_cast<std::uint32_t>(mesh.nodes.size()));
  header->set_tets(static_cast<std::uint32_t>(mesh.tets.size()));
  header->set_facets(static_cast<std::uint32_t>(mesh.facets.size()));
  std::string all;
  for (const Array& array : arrays) {
    auto* entry = header->add_arrays();
    entry->set_array(array.id);
    entry->set_bytes(array.bytes.size());
    entry->set_count(static_cast<std::uint32_t>(array.count));
    all += array.bytes;
  }
  for (const Array& array : arrays) {
    for (std::size_t at = 0; at < array.bytes.size(); at += part_size) {
      auto* part = messages.emplace_back().mutable_part();
      part->set_array(array.id);
      part->set_offset(at);
      part->set_data(array.bytes.substr(at, part_size));
      part->set_crc32c(crc32c(part->data()));
    }
  }
  const auto parts = static_cast<std::uint32_t>(messages.size() - 1);
  auto* end = messages.emplace_back().mutable_end();
  Sha256 digest;
  digest.update(all);
  end->set_sha256(digest.finish());
  end->set_bytes(all.size());
  end->set_parts(parts);
  return messages;
}

}  // namespace remeshd::client
