// SPDX-License-Identifier: Apache-2.0
#include "client/library/mesh_assembler.h"

#include <array>
#include <bit>
#include <cstring>

#include "remeshd/error.h"

namespace remeshd::client {
namespace {

using remesh::v1::MeshArray;

static_assert(std::endian::native == std::endian::little, "arrays are copied as they lie");

[[noreturn]] void lost(const std::string& what) {
  remesh::v1::Error error;
  error.set_code(remesh::v1::Error::DATA_LOSS);
  error.set_reason("MeshDamaged");
  error.set_stage("transfer");
  error.set_message("the mesh arrived damaged: " + what);
  error.set_hint("fetch it again");
  throw CallError(std::move(error));
}

std::string name_of(MeshArray array) { return remesh::v1::MeshArray_Name(array); }

/// Splits text into its lines of names.
std::vector<std::vector<std::string>> lines(const std::string& text, MeshArray array) {
  std::vector<std::vector<std::string>> out;
  if (!text.empty() && text.back() != '\n') lost(name_of(array) + " ends within a line");
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = text.find('\n', at);
    auto& names = out.emplace_back();
    while (at < end) {
      const std::size_t stop = std::min(text.find(' ', at), end);
      names.push_back(text.substr(at, stop - at));
      at = stop + 1;
    }
    at = end + 1;
  }
  return out;
}

template <class T>
std::vector<T> values(const std::string& bytes, MeshArray array) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (bytes.size() % sizeof(T) != 0) lost(name_of(array) + " has a broken last element");
  std::vector<T> out(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}

void check_index(std::int64_t index, std::int64_t low, std::size_t size, MeshArray array) {
  if (index < low || index >= static_cast<std::int64_t>(size))
    lost(name_of(array) + " has an index out of range");
}

/// Checks that what refers to what is there.
void check_mesh(const Mesh& mesh) {
  const auto same_size = [](std::size_t size, std::size_t wanted, MeshArray array) {
    if (size != wanted) lost(name_of(array) + " has the wrong count");
  };
  const std::size_t nodes = mesh.nodes.size();
  const std::size_t tets = mesh.tets.size();
  same_size(mesh.node_ids.size(), nodes, MeshArray::NODE_IDS);
  same_size(mesh.tet_ids.size(), tets, MeshArray::TET_IDS);
  same_size(mesh.tet_cell.size(), tets, MeshArray::TET_CELLS);
  same_size(mesh.node_origin.size(), nodes, MeshArray::NODE_ORIGINS);
  same_size(mesh.original_node.size(), nodes, MeshArray::ORIGINAL_NODES);
  same_size(mesh.node_transform.size(), nodes, MeshArray::NODE_TRANSFORMS);
  same_size(mesh.original_tet.size(), tets, MeshArray::ORIGINAL_TETS);
  same_size(mesh.transform_features.size(), mesh.transforms.size(), MeshArray::TRANSFORM_FEATURES);
  for (const auto& tet : mesh.tets)
    for (const std::int32_t node : tet) check_index(node, 0, nodes, MeshArray::TETS);
  for (const Facet& facet : mesh.facets) {
    for (const std::int32_t node : facet.nodes) check_index(node, 0, nodes, MeshArray::FACETS);
    check_index(facet.tet, 0, tets, MeshArray::FACETS);
    check_index(facet.group, 0, mesh.facet_groups.size(), MeshArray::FACETS);
    // Exactly one corner of the tet is not the facet's; the file formats count on it.
    int shared = 0;
    for (const std::int32_t corner : mesh.tets[static_cast<std::size_t>(facet.tet)])
      for (const std::int32_t node : facet.nodes) shared += corner == node ? 1 : 0;
    if (shared != 3) lost("a facet is not one of its tet");
  }
  for (const std::int32_t cell : mesh.tet_cell)
    check_index(cell, 0, mesh.cell_owners.size(), MeshArray::TET_CELLS);
  for (const std::int32_t transform : mesh.node_transform)
    check_index(transform, -1, mesh.transforms.size(), MeshArray::NODE_TRANSFORMS);
  for (const NodeOrigin origin : mesh.node_origin)
    check_index(static_cast<std::int64_t>(origin), 0, 3, MeshArray::NODE_ORIGINS);
}

}  // namespace

void MeshAssembler::add(const remesh::v1::MeshMessage& message) {
  if (ended_) lost("something follows its end");
  switch (message.message_case()) {
    case remesh::v1::MeshMessage::kHeader:
      return add_header(message.header());
    case remesh::v1::MeshMessage::kPart:
      return add_part(message.part());
    case remesh::v1::MeshMessage::kEnd:
      return add_end(message.end());
    case remesh::v1::MeshMessage::MESSAGE_NOT_SET:
      lost("an empty message");
  }
}

void MeshAssembler::add_header(const remesh::v1::MeshHeader& header) {
  if (has_header_) lost("a second header");
  has_header_ = true;
  header_ = header;
  for (const auto& array : header.arrays()) {
    expected_ += array.bytes();
    if (!arrays_.emplace(array.array(), "").second)
      lost(name_of(array.array()) + " is announced twice");
  }
}

void MeshAssembler::add_part(const remesh::v1::MeshPart& part) {
  if (!has_header_) lost("a part comes before the header");
  while (current_ < header_.arrays_size() && header_.arrays(current_).array() != part.array()) {
    const auto& passed = header_.arrays(current_);
    if (arrays_[passed.array()].size() != passed.bytes())
      lost(name_of(passed.array()) + " is not complete");
    ++current_;
  }
  if (current_ == header_.arrays_size()) lost("a part of an array that is not expected now");
  std::string& bytes = arrays_[part.array()];
  if (part.offset() != bytes.size()) lost(name_of(part.array()) + " has a gap");
  if (bytes.size() + part.data().size() > header_.arrays(current_).bytes())
    lost(name_of(part.array()) + " is longer than announced");
  if (crc32c(part.data()) != part.crc32c())
    lost("wrong CRC-32C in part " + std::to_string(parts_) + " of " + name_of(part.array()));
  sha256_.update(part.data());
  bytes += part.data();
  received_ += part.data().size();
  ++parts_;
}

void MeshAssembler::add_end(const remesh::v1::MeshEnd& end) {
  if (!has_header_) lost("an end comes before the header");
  if (end.parts() != parts_ || end.bytes() != received_) lost("parts are missing");
  for (const auto& array : header_.arrays())
    if (arrays_[array.array()].size() != array.bytes())
      lost(name_of(array.array()) + " is not complete");
  if (end.sha256() != sha256_.finish()) lost("wrong SHA-256");
  ended_ = true;
}

Mesh MeshAssembler::finish() const {
  if (!ended_) lost("its end is missing");
  const auto bytes = [&](MeshArray array) -> const std::string& {
    const auto found = arrays_.find(array);
    if (found == arrays_.end()) lost(name_of(array) + " is missing");
    return found->second;
  };
  const auto of = [&]<class T>(std::vector<T>& out, MeshArray array) {
    out = values<T>(bytes(array), array);
  };
  Mesh mesh;
  of(mesh.nodes, MeshArray::NODES);
  of(mesh.tets, MeshArray::TETS);
  of(mesh.node_ids, MeshArray::NODE_IDS);
  of(mesh.tet_ids, MeshArray::TET_IDS);
  static_assert(sizeof(Facet) == 5 * sizeof(std::int32_t));
  of(mesh.facets, MeshArray::FACETS);
  mesh.facet_groups = lines(bytes(MeshArray::FACET_GROUPS), MeshArray::FACET_GROUPS);
  of(mesh.tet_cell, MeshArray::TET_CELLS);
  mesh.cell_owners = lines(bytes(MeshArray::CELL_OWNERS), MeshArray::CELL_OWNERS);
  static_assert(sizeof(NodeOrigin) == 1);
  of(mesh.node_origin, MeshArray::NODE_ORIGINS);
  of(mesh.original_node, MeshArray::ORIGINAL_NODES);
  of(mesh.node_transform, MeshArray::NODE_TRANSFORMS);
  of(mesh.transforms, MeshArray::TRANSFORMS);
  for (const auto& line :
       lines(bytes(MeshArray::TRANSFORM_FEATURES), MeshArray::TRANSFORM_FEATURES))
    mesh.transform_features.push_back(line.empty() ? "" : line.front());
  of(mesh.original_tet, MeshArray::ORIGINAL_TETS);

  if (mesh.nodes.size() != header_.nodes() || mesh.tets.size() != header_.tets() ||
      mesh.facets.size() != header_.facets())
    lost("its counts are not those of its header");
  check_mesh(mesh);
  return mesh;
}

}  // namespace remeshd::client
