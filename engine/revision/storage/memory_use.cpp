#include "engine/revision/storage/memory_use.h"

#include <algorithm>
#include <utility>

#include "engine/revision/delaunay_state.h"

namespace remeshd {

namespace {

class Blocks {
 public:
  template <class T>
  void add(const CowVector<T>& pages) {
    for (std::size_t k = 0; k < pages.pages(); ++k)
      found_.push_back({pages.page(k).data(), CowVector<T>::page_bytes()});
  }
  void add(const CowVector<Cavity>& cavities) {
    for (std::size_t k = 0; k < cavities.pages(); ++k) {
      std::size_t bytes = cavities.page_bytes();
      for (const Cavity& c : cavities.page(k))
        bytes += (c.delaunay.capacity() + c.output.capacity()) * sizeof(std::int32_t);
      found_.push_back({cavities.page(k).data(), bytes});
    }
  }
  template <class T>
  void add(const std::vector<T>& values) {
    if (!values.empty()) found_.push_back({values.data(), values.capacity() * sizeof(T)});
  }
  void add(const SizeField& sizes) {
    if (const std::size_t bytes = sizes.bytes(); bytes > 0) found_.push_back({sizes.tree(), bytes});
  }
  template <class... Arrays>
  void add_all(const Arrays&... arrays) {
    (add(arrays), ...);
  }

  /// Each block once: an array may have the same page many times, if it is of one value throughout.
  std::vector<MemoryBlock> take() {
    std::ranges::sort(found_, {}, &MemoryBlock::address);
    const auto same = [](const MemoryBlock& a, const MemoryBlock& b) {
      return a.address == b.address;
    };
    found_.erase(std::unique(found_.begin(), found_.end(), same), found_.end());
    return std::move(found_);
  }

 private:
  std::vector<MemoryBlock> found_;
};

}  // namespace

std::vector<MemoryBlock> memory_blocks(const Revision& revision) {
  Blocks blocks;
  const OutputMesh& d = revision.output;
  blocks.add_all(d.mesh.nodes, d.mesh.tets, d.node_ids, d.tet_ids, d.groups.facets,
                 d.groups.tet_cell, d.map.node_origin, d.map.original_node, d.map.node_transform,
                 d.map.original_tet, d.node_sizes, revision.measures, revision.boxes);
  const MidNodes& mids = d.mids;
  blocks.add_all(mids.positions, mids.edges, mids.of_tets, mids.ids, mids.origin, mids.original,
                 mids.transform, mids.straightened);
  for (const GroupMembers& group : d.groups.of_model) blocks.add_all(group.facets, group.tets);
  if (const DelaunayState* m = revision.delaunay_state.get()) {
    m->mesh.visit_arrays([&](const auto&... arrays) { blocks.add_all(arrays...); });
    blocks.add_all(m->supports, m->tet_of_slot, m->cavities);
  }
  blocks.add(revision.dense_places);
  if (revision.sizes) blocks.add(*revision.sizes);
  if (const Anchor* a = revision.anchor.get()) blocks.add_all(a->nodes, a->supports);
  return blocks.take();
}

}  // namespace remeshd
