#include "server/service/mesh_messages.h"

#include <algorithm>
#include <set>
#include <utility>

#include "proto/checksum.h"
#include "server/limits.h"
#include "server/service/array_delta.h"
#include "server/service/encode.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

static_assert(static_cast<int>(ArrayName::Nodes) == v1::MESH_ARRAY_NODES &&
                  static_cast<int>(ArrayName::OriginalTets) == v1::MESH_ARRAY_ORIGINAL_TETS &&
                  static_cast<int>(ArrayName::NodeSizes) == v1::MESH_ARRAY_NODE_SIZES &&
                  static_cast<int>(ArrayName::MidNodes) == v1::MESH_ARRAY_MID_NODES &&
                  static_cast<int>(ArrayName::MidNodeTransforms) ==
                      v1::MESH_ARRAY_MID_NODE_TRANSFORMS &&
                  static_cast<int>(NumberType::F64) == v1::ARRAY_TYPE_F64 &&
                  static_cast<int>(NumberType::Text) == v1::ARRAY_TYPE_TEXT,
              "the session's numbers are the protocol's");

v1::MeshArray name_of(const MeshArray& array) {
  return static_cast<v1::MeshArray>(static_cast<int>(array.name));
}

std::uint32_t size_of(std::size_t size) { return static_cast<std::uint32_t>(size); }

std::string all_of(const MeshArray& array) {
  std::string bytes;
  bytes.reserve(array.bytes);
  array.read(0, array.bytes, bytes);
  return bytes;
}

}  // namespace

void check_selection(const v1::MeshSelection& selection) {
  for (const int array : selection.arrays())
    if (!v1::MeshArray_IsValid(array) || array == v1::MESH_ARRAY_UNSPECIFIED)
      throw error::option_invalid("arrays", "names an unknown array");
}

std::vector<v1::MeshArray> supported_arrays() {
  std::vector<v1::MeshArray> out;
  for (int array = 1; v1::MeshArray_IsValid(array); ++array)
    out.push_back(static_cast<v1::MeshArray>(array));
  return out;
}

MeshMessages::MeshMessages(HeldRevisionPtr revision, const HeldRevisionPtr& parent,
                           const v1::MeshSelection& selection)
    : content_(std::make_shared<Content>()) {
  check_selection(selection);
  content_->revision = std::move(revision);
  const HeldRevision& held = *content_->revision;
  const std::set<int> wanted(selection.arrays().begin(), selection.arrays().end());
  const bool delta = selection.delta() && parent;
  const auto of_parent = delta ? mesh_arrays(parent->revision.output) : std::vector<MeshArray>();
  for (MeshArray& array : mesh_arrays(held.revision.output)) {
    if (!wanted.empty() && !wanted.contains(name_of(array))) continue;
    Sent& sent = content_->arrays.emplace_back();
    sent.bytes = array.bytes;
    sent.array = std::move(array);
    if (delta) take_difference(sent, *parent, of_parent);
    held.digests.of(sent.array);
  }
}

void MeshMessages::take_difference(Sent& sent, const HeldRevision& parent,
                                   const std::vector<MeshArray>& of_parent) {
  const auto base = std::ranges::find(of_parent, sent.array.name, &MeshArray::name);
  if (base == of_parent.end() || base->type != sent.array.type ||
      base->components != sent.array.components)
    return;
  const MeshDigests& digests = content_->revision->digests;
  if (digests.of(sent.array, *base, parent.digests) == parent.digests.of(*base)) {
    sent.encoding = v1::MeshHeader::ENCODING_SAME;
    sent.bytes = 0;
  } else if (sent.array.type != NumberType::Text) {
    std::string delta = delta_of(sent.array, all_of(sent.array), all_of(*base)).SerializeAsString();
    if (delta.size() >= sent.bytes) return;
    sent.encoding = v1::MeshHeader::ENCODING_DELTA;
    sent.bytes = delta.size();
    sent.delta = std::move(delta);
  } else {
    return;
  }
  base_ = parent.record.id;
}

void MeshMessages::resume_from(const v1::MeshPosition& position) {
  const auto& arrays = content_->arrays;
  const auto found = std::ranges::find_if(
      arrays, [&](const Sent& sent) { return name_of(sent.array) == position.array(); });
  if (found == arrays.end())
    throw error::option_invalid("resume_from", "names an array that is not sent");
  if (position.offset() > found->bytes)
    throw error::option_invalid("resume_from", "lies behind the end of its array");
  array_ = static_cast<std::size_t>(found - arrays.begin());
  offset_ = position.offset();
}

std::uint64_t MeshMessages::own_bytes() const {
  std::uint64_t bytes = 0;
  for (const Sent& sent : content_->arrays) bytes += sent.delta.size();
  return bytes;
}

void MeshMessages::put_header(v1::MeshHeader& header) const {
  const HeldRevision& held = *content_->revision;
  const Revision& revision = held.revision;
  const OutputMesh& delivery = revision.output;
  header.set_revision(held.record.id);
  header.set_parent(held.record.parent);
  header.set_base(base_);
  header.set_model_name(revision.source.name);
  header.set_unit(revision.source.unit);
  header.set_order(revision.options.order);
  header.set_options(in_one_line(revision.options));
  header.set_algorithm_version(held.record.algorithm_version);
  header.set_nodes(size_of(delivery.mesh.nodes.size()));
  header.set_mid_nodes(size_of(delivery.mids.positions.size()));
  header.set_tets(size_of(delivery.mesh.tets.size()));
  header.set_facets(size_of(delivery.groups.facets.size()));
  for (const Sent& sent : content_->arrays) {
    const MeshArray& array = sent.array;
    v1::MeshHeader::Array& entry = *header.add_arrays();
    entry.set_array(name_of(array));
    entry.set_type(static_cast<v1::ArrayType>(static_cast<int>(array.type)));
    entry.set_components(array.components);
    entry.set_count(array.count);
    entry.set_bytes(array.bytes);
    entry.set_digest(held.digests.of(array));
    entry.set_encoding(sent.encoding);
    entry.set_data_bytes(sent.bytes);
  }
}

void MeshMessages::put_part(v1::MeshPart& part, PartData& data) {
  const Sent& sent = content_->arrays[array_];
  const std::uint64_t size = std::min<std::uint64_t>(limits::kMeshPartBytes, sent.bytes - offset_);
  data.owner = content_;
  data.bytes = size;
  if (sent.encoding == v1::MeshHeader::ENCODING_DELTA) {
    data.pieces.push_back(std::string_view(sent.delta).substr(offset_, size));
  } else {
    sent.array.pieces(offset_, size, [&](std::string_view piece) { data.pieces.push_back(piece); });
  }
  std::uint32_t crc = 0;
  for (const std::string_view piece : data.pieces) crc = crc32c(piece, crc);
  part.set_array(name_of(sent.array));
  part.set_offset(offset_);
  part.set_crc32c(crc);
  offset_ += size;
  bytes_ += size;
  ++parts_;
}

bool MeshMessages::next(v1::MeshMessage& message, PartData& data) {
  message.Clear();
  data = {};
  const std::vector<Sent>& arrays = content_->arrays;
  if (!begun_) {
    begun_ = true;
    put_header(*message.mutable_header());
    return true;
  }
  while (array_ < arrays.size() && offset_ == arrays[array_].bytes) {
    ++array_;
    offset_ = 0;
  }
  if (array_ < arrays.size()) {
    put_part(*message.mutable_part(), data);
    return true;
  }
  if (ended_) return false;
  ended_ = true;
  v1::MeshEnd& end = *message.mutable_end();
  end.set_bytes(bytes_);
  end.set_parts(parts_);
  return true;
}

}  // namespace remeshd
