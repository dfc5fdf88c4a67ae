#include "server/service/mesh_messages.h"

#include <algorithm>
#include <set>
#include <utility>

#include "proto/checksum.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

// A message may have 1 MiB; around the data there are at most a few dozen bytes.
constexpr std::size_t kPartBytes = (std::size_t{1} << 20) - 1024;

static_assert(static_cast<int>(ArrayName::Nodes) == v1::MESH_ARRAY_NODES &&
                  static_cast<int>(ArrayName::OriginalTets) == v1::MESH_ARRAY_ORIGINAL_TETS &&
                  static_cast<int>(NumberType::F64) == v1::ARRAY_TYPE_F64 &&
                  static_cast<int>(NumberType::Text) == v1::ARRAY_TYPE_TEXT,
              "the session's numbers are the protocol's");

v1::MeshArray name_of(const MeshArray& array) {
  return static_cast<v1::MeshArray>(static_cast<int>(array.name));
}

bool is_supported(int array) {
  return array >= v1::MESH_ARRAY_NODES && array <= static_cast<int>(kArrayNames);
}

std::set<int> checked_names(const v1::MeshSelection& selection) {
  if (selection.delta()) throw error::unsupported("selection.delta");
  for (const int array : selection.arrays()) {
    if (!v1::MeshArray_IsValid(array) || array == v1::MESH_ARRAY_UNSPECIFIED)
      throw error::option_invalid("arrays", "names an unknown array");
    if (!is_supported(array))
      throw error::unsupported(v1::MeshArray_Name(static_cast<v1::MeshArray>(array)));
  }
  return {selection.arrays().begin(), selection.arrays().end()};
}

std::uint32_t size_of(std::size_t size) { return static_cast<std::uint32_t>(size); }

}  // namespace

std::vector<v1::MeshArray> supported_arrays() {
  std::vector<v1::MeshArray> out;
  for (int array = 1; v1::MeshArray_IsValid(array); ++array)
    if (is_supported(array)) out.push_back(static_cast<v1::MeshArray>(array));
  return out;
}

MeshMessages::MeshMessages(HeldRevisionPtr revision, const v1::MeshSelection& selection)
    : revision_(std::move(revision)) {
  const std::set<int> wanted = checked_names(selection);
  for (MeshArray& array : mesh_arrays(revision_->revision.delivery)) {
    if (!wanted.empty() && !wanted.contains(name_of(array))) continue;
    revision_->digests.of(array);
    arrays_.push_back(std::move(array));
  }
}

void MeshMessages::put_header(v1::MeshHeader& header) const {
  const Revision& revision = revision_->revision;
  const Delivery& delivery = revision.delivery;
  header.set_revision(revision_->record.id);
  header.set_parent(revision_->record.parent);
  header.set_model_name(revision.source.name);
  header.set_unit(revision.source.unit);
  header.set_order(1);
  header.set_nodes(size_of(delivery.mesh.nodes.size()));
  header.set_tets(size_of(delivery.mesh.tets.size()));
  header.set_facets(size_of(delivery.groups.facets.size()));
  for (const MeshArray& array : arrays_) {
    v1::MeshHeader::Array& entry = *header.add_arrays();
    entry.set_array(name_of(array));
    entry.set_type(static_cast<v1::ArrayType>(static_cast<int>(array.type)));
    entry.set_components(array.components);
    entry.set_count(array.count);
    entry.set_bytes(array.bytes);
    entry.set_digest(revision_->digests.of(array));
    entry.set_encoding(v1::MeshHeader::ENCODING_WHOLE);
    entry.set_data_bytes(array.bytes);
  }
}

void MeshMessages::put_part(v1::MeshPart& part) {
  const MeshArray& array = arrays_[array_];
  std::string& data = *part.mutable_data();
  const std::size_t size = std::min<std::uint64_t>(kPartBytes, array.bytes - offset_);
  data.reserve(size);
  array.read(offset_, size, data);
  part.set_array(name_of(array));
  part.set_offset(offset_);
  part.set_crc32c(crc32c(data));
  offset_ += size;
  bytes_ += size;
  ++parts_;
}

bool MeshMessages::next(v1::MeshMessage& message) {
  message.Clear();
  if (!begun_) {
    begun_ = true;
    put_header(*message.mutable_header());
    return true;
  }
  while (array_ < arrays_.size() && offset_ == arrays_[array_].bytes) {
    ++array_;
    offset_ = 0;
  }
  if (array_ < arrays_.size()) {
    put_part(*message.mutable_part());
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
