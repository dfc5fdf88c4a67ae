#include "server/session/held_revisions.h"

namespace remeshd {
namespace {

template <typename T>
std::uint64_t bytes_of(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

}  // namespace

std::uint64_t memory_of(const Revision& revision) {
  const Delivery& d = revision.delivery;
  const std::uint64_t mesh = bytes_of(d.mesh.nodes) + bytes_of(d.mesh.tets);
  std::uint64_t bytes = mesh + bytes_of(d.node_ids) + bytes_of(d.tet_ids) +
                        bytes_of(d.groups.facets) + bytes_of(d.groups.tet_cell) +
                        bytes_of(d.map.node_origin) + bytes_of(d.map.original_node) +
                        bytes_of(d.map.node_transform) + bytes_of(d.map.original_tet) +
                        bytes_of(revision.measures);
  // Twice: what the boundary is joined from is kept too, with shapes of the CAD kernel.
  const BoundaryModel& boundary = revision.cells.boundary;
  for (const BoundaryFace& face : boundary.faces)
    bytes += 2 * (bytes_of(face.points) + bytes_of(face.triangles));
  // The master is a mesh of its own with adjacency, supports and sources: about three times this.
  if (revision.master != nullptr) bytes += 3 * mesh;
  // Models, names, shapes of the CAD kernel: some 20 KB a feature or face.
  return bytes + 4096 + 20000 * (revision.model.features.size() + boundary.faces.size());
}

HeldRevisionPtr HeldRevisions::find(const std::string& id) {
  const std::scoped_lock lock(mutex_);
  const auto entry = by_id_.find(id);
  if (entry == by_id_.end()) return nullptr;
  order_.splice(order_.begin(), order_, entry->second);
  return entry->second->revision;
}

bool HeldRevisions::contains(const std::string& id) const {
  const std::scoped_lock lock(mutex_);
  return by_id_.contains(id);
}

void HeldRevisions::drop(Order::iterator entry) {
  bytes_ -= entry->bytes;
  by_id_.erase(entry->revision->record.id);
  order_.erase(entry);
}

void HeldRevisions::insert(HeldRevisionPtr revision) {
  const std::uint64_t bytes = memory_of(revision->revision);
  const std::scoped_lock lock(mutex_);
  const std::string& id = revision->record.id;
  if (const auto entry = by_id_.find(id); entry != by_id_.end()) drop(entry->second);
  order_.push_front({std::move(revision), bytes});
  by_id_[order_.front().revision->record.id] = order_.begin();
  bytes_ += bytes;
  if (!evict_) return;
  // The newest stays however large it is: the next request most likely asks for it.
  while (bytes_ > budget_ && order_.size() > 1) drop(std::prev(order_.end()));
}

void HeldRevisions::erase(const std::string& id) {
  const std::scoped_lock lock(mutex_);
  if (const auto entry = by_id_.find(id); entry != by_id_.end()) drop(entry->second);
}

std::size_t HeldRevisions::count() const {
  const std::scoped_lock lock(mutex_);
  return order_.size();
}
std::uint64_t HeldRevisions::bytes() const {
  const std::scoped_lock lock(mutex_);
  return bytes_;
}

}  // namespace remeshd
