#include "server/service/mesh_messages.h"

#include <algorithm>
#include <bit>

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
std::string_view bytes_of(const std::vector<T>& values) {
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
  add(v1::NODES, d.mesh.nodes.size(), bytes_of(d.mesh.nodes));
  add(v1::TETS, d.mesh.tets.size(), bytes_of(d.mesh.tets));
  add(v1::NODE_IDS, d.node_ids.size(), bytes_of(d.node_ids));
  add(v1::TET_IDS, d.tet_ids.size(), bytes_of(d.tet_ids));
  add(v1::FACETS, g.facets.size(), bytes_of(g.facets));
  add_text(v1::FACET_GROUPS, g.facet_groups.size(), lines(g.facet_groups));
  add(v1::TET_CELLS, g.tet_cell.size(), bytes_of(g.tet_cell));
  add_text(v1::CELL_OWNERS, g.cell_owners.size(), lines(g.cell_owners));
  add(v1::NODE_ORIGINS, m.node_origin.size(), bytes_of(m.node_origin));
  add(v1::ORIGINAL_NODES, m.original_node.size(), bytes_of(m.original_node));
  add(v1::NODE_TRANSFORMS, m.node_transform.size(), bytes_of(m.node_transform));
  add(v1::TRANSFORMS, m.transforms.size(), bytes_of(m.transforms));
  add_text(v1::TRANSFORM_FEATURES, m.transform_features.size(), lines(m.transform_features));
  add(v1::ORIGINAL_TETS, m.original_tet.size(), bytes_of(m.original_tet));
}

bool MeshMessages::wanted(v1::MeshArray name) const {
  return wanted_.empty() || std::find(wanted_.begin(), wanted_.end(), name) != wanted_.end();
}

void MeshMessages::add(v1::MeshArray name, std::size_t count, std::string_view bytes) {
  if (wanted(name)) arrays_.push_back({name, bytes, static_cast<std::uint32_t>(count), {}});
}

void MeshMessages::add_text(v1::MeshArray name, std::size_t count, std::string text) {
  if (wanted(name))
    arrays_.push_back({name, {}, static_cast<std::uint32_t>(count), std::move(text)});
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
    entry.set_bytes(array.owned.empty() ? array.bytes.size() : array.owned.size());
    entry.set_count(array.count);
  }
}

void MeshMessages::part(v1::MeshPart& part) {
  const Array& array = arrays_[array_];
  const std::string_view all = array.owned.empty() ? array.bytes : std::string_view(array.owned);
  const std::string_view data = all.substr(offset_, kPartBytes);
  part.set_array(array.name);
  part.set_offset(offset_);
  part.set_data(data.data(), data.size());
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
  const auto size = [](const Array& array) {
    return array.owned.empty() ? array.bytes.size() : array.owned.size();
  };
  while (array_ < arrays_.size() && offset_ == size(arrays_[array_])) {
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
