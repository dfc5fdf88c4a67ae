#include "server/service/mesh_messages.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <span>
#include <utility>

#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

static_assert(std::endian::native == std::endian::little, "arrays are sent as they lie in memory");
static_assert(sizeof(Vec3) == 24 && sizeof(Tet) == 16 && sizeof(MeshFacet) == 20 &&
              sizeof(Transform) == 96 && sizeof(NodeOrigin) == 1);

// A message may have 1 MiB; around the data there are at most a few dozen bytes.
constexpr std::size_t kPartBytes = (std::size_t{1} << 20) - 1024;

template <typename T>
std::string_view bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::string lines(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (const auto& names : rows) {
    for (std::size_t i = 0; i < names.size(); ++i) text += (i > 0 ? " " : "") + names[i];
    text += '\n';
  }
  return text;
}

std::string lines(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += name + '\n';
  return text;
}

}  // namespace

MeshMessages::MeshMessages(HeldRevisionPtr revision, const std::vector<v1::MeshArray>& arrays)
    : revision_(std::move(revision)), wanted_(arrays) {
  for (const v1::MeshArray name : wanted_)
    if (!v1::MeshArray_IsValid(name) || name == v1::MESH_ARRAY_UNSPECIFIED)
      throw error::option_invalid("arrays", "names an unknown array");
  const Delivery& d = revision_->revision.delivery;
  const MeshGroups& g = d.groups;
  const NodeMap& m = d.map;
  add(v1::NODES, d.mesh.nodes);
  add(v1::TETS, d.mesh.tets);
  add(v1::NODE_IDS, d.node_ids);
  add(v1::TET_IDS, d.tet_ids);
  add(v1::FACETS, g.facets);
  add_text(v1::FACET_GROUPS, g.facet_groups.size(), lines(g.facet_groups));
  add(v1::TET_CELLS, g.tet_cell);
  add_text(v1::CELL_OWNERS, g.cell_owners.size(), lines(g.cell_owners));
  add(v1::NODE_ORIGINS, m.node_origin);
  add(v1::ORIGINAL_NODES, m.original_node);
  add(v1::NODE_TRANSFORMS, m.node_transform);
  add(v1::TRANSFORMS, m.transforms);
  add_text(v1::TRANSFORM_FEATURES, m.transform_features.size(), lines(m.transform_features));
  add(v1::ORIGINAL_TETS, m.original_tet);
}

bool MeshMessages::wanted(v1::MeshArray name) const {
  return wanted_.empty() || std::find(wanted_.begin(), wanted_.end(), name) != wanted_.end();
}

template <class T>
void MeshMessages::add(v1::MeshArray name, const Pages<T>& values) {
  if (!wanted(name)) return;
  arrays_.push_back({name, static_cast<std::uint32_t>(values.size()), values.size() * sizeof(T),
                     [&values](std::uint64_t offset) {
                       constexpr std::size_t kPage = Pages<T>::page_bytes();
                       return bytes_of(values.page(offset / kPage)).substr(offset % kPage);
                     }});
}

template <class T>
void MeshMessages::add(v1::MeshArray name, const std::vector<T>& values) {
  if (!wanted(name)) return;
  const std::string_view bytes = bytes_of(std::span(values));
  arrays_.push_back({name, static_cast<std::uint32_t>(values.size()), bytes.size(),
                     [bytes](std::uint64_t offset) { return bytes.substr(offset); }});
}

void MeshMessages::add_text(v1::MeshArray name, std::size_t count, std::string text) {
  if (!wanted(name)) return;
  const std::uint64_t bytes = text.size();
  arrays_.push_back({name, static_cast<std::uint32_t>(count), bytes,
                     [text = std::make_shared<const std::string>(std::move(text))](
                         std::uint64_t offset) { return std::string_view(*text).substr(offset); }});
}

void MeshMessages::header(v1::MeshHeader& header) const {
  const Delivery& delivery = revision_->revision.delivery;
  header.set_revision(revision_->record.id);
  header.set_parent(revision_->record.parent);
  header.set_nodes(static_cast<std::uint32_t>(delivery.mesh.nodes.size()));
  header.set_tets(static_cast<std::uint32_t>(delivery.mesh.tets.size()));
  header.set_facets(static_cast<std::uint32_t>(delivery.groups.facets.size()));
  for (const Array& array : arrays_) {
    v1::MeshHeader::Array& entry = *header.add_arrays();
    entry.set_array(array.name);
    entry.set_bytes(array.bytes);
    entry.set_count(array.count);
  }
}

void MeshMessages::part(v1::MeshPart& part) {
  const Array& array = arrays_[array_];
  std::string& data = *part.mutable_data();
  const std::size_t size = std::min<std::uint64_t>(kPartBytes, array.bytes - offset_);
  data.reserve(size);
  while (data.size() < size)
    data += array.from(offset_ + data.size()).substr(0, size - data.size());
  part.set_array(array.name);
  part.set_offset(offset_);
  part.set_crc32c(crc32c(data));
  sum_.update(data);
  offset_ += data.size();
  bytes_ += data.size();
  ++parts_;
}

bool MeshMessages::next(v1::MeshMessage& message) {
  message.Clear();
  if (!begun_) {
    begun_ = true;
    header(*message.mutable_header());
    return true;
  }
  while (array_ < arrays_.size() && offset_ == arrays_[array_].bytes) {
    ++array_;
    offset_ = 0;
  }
  if (array_ < arrays_.size()) {
    part(*message.mutable_part());
    return true;
  }
  if (ended_) return false;
  ended_ = true;
  v1::MeshEnd& end = *message.mutable_end();
  end.set_sha256(sum_.finish());
  end.set_bytes(bytes_);
  end.set_parts(parts_);
  return true;
}

}  // namespace remeshd
