// SPDX-License-Identifier: Apache-2.0
#include "client/library/mesh_assembler.h"

#include <algorithm>
#include <optional>

#include "client/library/array_delta.h"
#include "client/library/array_digest.h"
#include "client/library/check_mesh.h"
#include "client/library/mesh_arrays.h"
#include "client/library/mesh_damaged.h"
#include "proto/checksum.h"

namespace remeshd::client {
namespace {

using remesh::v1::MeshArray;
using remesh::v1::MeshHeader;

/// The rows that an array has in a mesh with this header; nothing where the header does not say.
std::optional<std::uint32_t> rows_of(RowOf what, const MeshHeader& header) {
  switch (what) {
    case RowOf::Node:
      return header.nodes();
    case RowOf::Tet:
      return header.tets();
    case RowOf::Facet:
      return header.facets();
    case RowOf::MidNode:
      return header.mid_nodes();
    case RowOf::Other:
      return {};
  }
  return {};
}

/// Whether a mesh cannot be without an array: that of a model without groups has none, an even one
/// no sizes, one of first order no mid-nodes.
bool has_to_be(MeshArray array, const MeshHeader& header) {
  if (array >= remesh::v1::MESH_ARRAY_GROUP_NAMES && array <= remesh::v1::MESH_ARRAY_NODE_SIZES)
    return false;
  const bool of_second_order = array >= remesh::v1::MESH_ARRAY_MID_NODES &&
                               array <= remesh::v1::MESH_ARRAY_MID_NODE_TRANSFORMS;
  return !of_second_order || header.order() == 2;
}

ArrayShape shape_of(const MeshHeader::Array& entry) { return {entry.type(), entry.components()}; }

}  // namespace

MeshAssembler::MeshAssembler(const std::vector<MeshArray>& arrays,
                             std::vector<std::shared_ptr<const Mesh>> bases)
    : wanted_(arrays.begin(), arrays.end()), bases_(std::move(bases)) {
  if (wanted_.empty())
    for (const KnownArray& known : known_arrays()) wanted_.insert(known.array);
}

void MeshAssembler::add(const remesh::v1::MeshMessage& message) {
  if (ended_) mesh_damaged("something follows its end");
  switch (message.message_case()) {
    case remesh::v1::MeshMessage::kHeader:
      return add_header(message.header());
    case remesh::v1::MeshMessage::kPart:
      return add_part(message.part());
    case remesh::v1::MeshMessage::kEnd:
      return add_end(message.end());
    case remesh::v1::MeshMessage::MESSAGE_NOT_SET:
      mesh_damaged("an empty message");
  }
}

void MeshAssembler::add_header(const MeshHeader& header) {
  if (resumed_) return add_header_again(header);
  if (has_header_) mesh_damaged("a second header");
  has_header_ = true;
  header_ = header;
  mesh_.revision = header.revision();
  mesh_.parent = header.parent();
  mesh_.model_name = header.model_name();
  mesh_.unit = header.unit();
  mesh_.options = header.options();
  mesh_.algorithm_version = header.algorithm_version();
  for (const MeshHeader::Array& entry : header.arrays()) {
    check_entry(entry);
    expected_ += entry.data_bytes();
  }
  find_base();
}

std::optional<remesh::v1::MeshPosition> MeshAssembler::resume() {
  if (!has_header_) return std::nullopt;
  resumed_ = true;
  remesh::v1::MeshPosition position;
  if (current_ < header_.arrays_size()) {
    position.set_array(header_.arrays(current_).array());
    position.set_offset(data_.size());
  } else if (header_.arrays_size() > 0) {
    const MeshHeader::Array& last = *header_.arrays().rbegin();
    position.set_array(last.array());
    position.set_offset(last.data_bytes());
  }
  return position;
}

void MeshAssembler::add_header_again(const MeshHeader& header) {
  resumed_ = false;
  parts_ = 0;
  part_bytes_ = 0;
  // Digests and lengths in it say that the data are the same.
  if (header.SerializeAsString() != header_.SerializeAsString())
    mesh_damaged("it is another one than before its transfer broke");
}

void MeshAssembler::check_entry(const MeshHeader::Array& entry) {
  const std::string name = name_of(entry.array());
  const KnownArray* known = find_array(entry.array());
  if (known == nullptr) return;  // of a newer protocol: passed over
  if (!arrays_.insert(entry.array()).second) mesh_damaged(name + " is announced twice");
  if (shape_of(entry) != known->shape) mesh_damaged(name + " is of another type");
  const std::optional<std::uint32_t> rows = rows_of(known->row_of, header_);
  if (rows && entry.count() != *rows) mesh_damaged(name + " has the wrong count");
  const bool is_text = entry.type() == remesh::v1::ARRAY_TYPE_TEXT;
  if (!is_text && entry.bytes() != entry.count() * row_bytes(known->shape))
    mesh_damaged(name + " has another size than its rows");
  switch (entry.encoding()) {
    case MeshHeader::ENCODING_WHOLE:
      if (entry.data_bytes() != entry.bytes())
        mesh_damaged(name + " is sent whole, but not all of it");
      return;
    case MeshHeader::ENCODING_SAME:
      if (entry.data_bytes() != 0) mesh_damaged(name + " is sent although it is the base's");
      return;
    case MeshHeader::ENCODING_DELTA:
      if (is_text) mesh_damaged(name + " is text, which has no deltas");
      return;
    default:
      mesh_damaged(name + " has an unknown encoding");
  }
}

void MeshAssembler::find_base() {
  const bool needed = std::ranges::any_of(header_.arrays(), [](const MeshHeader::Array& entry) {
    return find_array(entry.array()) != nullptr && entry.encoding() != MeshHeader::ENCODING_WHOLE;
  });
  if (!needed) return;
  const auto found = std::ranges::find_if(bases_, [&](const auto& mesh) {
    return mesh != nullptr && mesh->revision == header_.base();
  });
  if (header_.base().empty() || found == bases_.end())
    mesh_damaged("it is a delta against the mesh of revision '" + header_.base() +
                 "', which is not here");
  base_ = *found;
}

void MeshAssembler::add_part(const remesh::v1::MeshPart& part) {
  if (!has_header_) mesh_damaged("a part comes before the header");
  while (current_ < header_.arrays_size() && header_.arrays(current_).array() != part.array())
    end_array();
  if (current_ == header_.arrays_size())
    mesh_damaged("a part of an array that is not expected now");
  const std::string name = name_of(part.array());
  if (part.offset() != data_.size()) mesh_damaged(name + " has a gap");
  if (part.data().size() > header_.arrays(current_).data_bytes() - data_.size())
    mesh_damaged(name + " is longer than announced");
  if (crc32c(part.data()) != part.crc32c())
    mesh_damaged("wrong CRC-32C in part " + std::to_string(parts_) + " of " + name);
  data_ += part.data();
  received_ += part.data().size();
  part_bytes_ += part.data().size();
  ++parts_;
}

void MeshAssembler::add_end(const remesh::v1::MeshEnd& end) {
  if (!has_header_) mesh_damaged("an end comes before the header");
  while (current_ < header_.arrays_size()) end_array();
  if (end.parts() != parts_ || end.bytes() != part_bytes_) mesh_damaged("parts are missing");
  ended_ = true;
}

/// All of the current array has come: takes it into the mesh and goes on to the next.
void MeshAssembler::end_array() {
  const MeshHeader::Array& entry = header_.arrays(current_++);
  const std::string name = name_of(entry.array());
  if (data_.size() != entry.data_bytes()) mesh_damaged(name + " is not complete");
  if (const KnownArray* known = find_array(entry.array())) {
    const std::string bytes = decode(entry);
    if (bytes.size() != entry.bytes() || array_digest(bytes) != entry.digest())
      mesh_damaged("wrong digest of " + name);
    known->read(bytes, mesh_);
    const bool is_text = entry.type() == remesh::v1::ARRAY_TYPE_TEXT;
    if (is_text && std::ranges::count(bytes, '\n') != entry.count())
      mesh_damaged(name + " has the wrong count");
  }
  data_.clear();
}

std::string MeshAssembler::decode(const MeshHeader::Array& entry) {
  if (entry.encoding() == MeshHeader::ENCODING_WHOLE) return std::move(data_);
  std::string of_base = find_array(entry.array())->write(*base_);
  if (entry.encoding() == MeshHeader::ENCODING_SAME) return of_base;
  remesh::v1::ArrayDelta delta;
  if (!delta.ParseFromString(data_))
    mesh_damaged("the delta of " + name_of(entry.array()) + " cannot be read");
  return apply_delta(delta, shape_of(entry), entry.count(), of_base);
}

Mesh MeshAssembler::finish() {
  if (!ended_) mesh_damaged("its end is missing");
  for (const MeshArray array : wanted_)
    if (find_array(array) != nullptr && !arrays_.contains(array) && has_to_be(array, header_))
      mesh_damaged(name_of(array) + " is missing");
  const bool transforms = arrays_.contains(remesh::v1::MESH_ARRAY_TRANSFORMS) &&
                          arrays_.contains(remesh::v1::MESH_ARRAY_TRANSFORM_FEATURES);
  if (transforms && mesh_.transform_features.size() != mesh_.transforms.size())
    mesh_damaged("TRANSFORM_FEATURES has the wrong count");
  check_mesh(mesh_, arrays_);
  return std::move(mesh_);
}

}  // namespace remeshd::client
