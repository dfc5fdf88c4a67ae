#include "engine/revision/storage/stored_revision.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

#include "engine/base/error.h"
#include "engine/mesh/tet_boxes.h"
#include "engine/revision/delaunay_state.h"
#include "engine/revision/group_figures.h"
#include "engine/revision/group_members.h"
#include "engine/revision/storage/older_format.h"
#include "engine/revision/storage/stored_documents.h"
#include "engine/revision/storage/stored_revision_check.h"

namespace remeshd {
namespace {

static_assert(std::endian::native == std::endian::little,
              "arrays are stored as they lie in memory");

// Names of arrays keep the words of older versions: `delivery` is the output mesh, `master` the
// Delaunay state, `clusters` are its cavities.
constexpr const char* kDocuments = "documents";
constexpr const char* kNodeSizes = "sizes.nodes";  // of a mesh that is not even

/// The numbers that an element consists of, without gaps in memory.
struct Layout {
  StoredType type;
  std::uint32_t components;
};
template <class T>
constexpr Layout layout_of() {
  if constexpr (std::is_same_v<T, Vec3>)
    return {StoredType::F64, 3};
  else if constexpr (std::is_same_v<T, Box>)
    return {StoredType::F64, 6};
  else if constexpr (std::is_same_v<T, Tet>)
    return {StoredType::I32, 4};
  else if constexpr (std::is_same_v<T, Triangle>)
    return {StoredType::I32, 3};
  else if constexpr (std::is_same_v<T, double>)
    return {StoredType::F64, 1};
  else if constexpr (std::is_same_v<T, std::int32_t>)
    return {StoredType::I32, 1};
  else if constexpr (std::is_same_v<T, std::uint64_t>)
    return {StoredType::U64, 1};
  else if constexpr (std::is_same_v<T, std::uint8_t> || std::is_same_v<T, NodeOrigin>)
    return {StoredType::U8, 1};
  else if constexpr (std::is_same_v<T, Transform>)
    return {StoredType::F64, 12};
  else  // slots of the Delaunay mesh, whose type is its own: vertices, then neighbours
    return {StoredType::I32, static_cast<std::uint32_t>(sizeof(T) / sizeof(std::int32_t))};
}

// ---------------------------------------------------------------------------------------------
// Out

class Writer {
 public:
  template <class T>
  void operator()(const char* name, const CowVector<T>& values, const std::string& like = {}) {
    StoredArray& array = begin<T>(name);
    array.like = like;
    array.piece_bytes = CowVector<T>::page_bytes();
    for (std::size_t k = 0; k < values.pages(); ++k) {
      const std::span<const T> page = values.page(k);
      array.pieces.emplace_back(reinterpret_cast<const char*>(page.data()), page.size_bytes());
    }
  }
  template <class T>
  void operator()(const char* name, const std::vector<T>& values, const std::string& like = {}) {
    StoredArray& array = begin<T>(name);
    array.like = like;
    array.own({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
  }
  void bytes(const char* name, std::string text) { begin<std::uint8_t>(name).own(std::move(text)); }
  StoredArrays take() { return std::move(image_); }

 private:
  template <class T>
  StoredArray& begin(const char* name) {
    constexpr Layout kLayout = layout_of<T>();
    static_assert(sizeof(T) % kLayout.components == 0);
    return image_.arrays.emplace_back(
        StoredArray{.name = name, .type = kLayout.type, .components = kLayout.components});
  }
  StoredArrays image_;
};

// ---------------------------------------------------------------------------------------------
// In

class Reader {
 public:
  explicit Reader(const StoredArrays& image) : image_(image) {}

  template <class T>
  void operator()(const char* name, std::vector<T>& values) const {
    const std::string bytes = flat<T>(name);
    values.resize(bytes.size() / sizeof(T));
    if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  }
  /// Shares the pages of `alike` that are the same; it may be null.
  template <class T>
  void operator()(const char* name, CowVector<T>& values, const CowVector<T>* alike) const {
    std::vector<T> all;
    (*this)(name, all);
    values = alike ? CowVector<T>(std::span<const T>(all), *alike) : CowVector<T>(all);
  }
  [[nodiscard]] std::string bytes(const char* name) const { return flat<std::uint8_t>(name); }

 private:
  template <class T>
  std::string flat(const char* name) const {
    const StoredArray* array = image_.find(name);
    if (array == nullptr) throw error::internal("store", std::string("no array ") + name);
    constexpr Layout kLayout = layout_of<T>();
    if (array->type != kLayout.type || array->components != kLayout.components ||
        array->size() % sizeof(T) != 0)
      throw error::internal("store", std::string("another type of the array ") + name);
    return array->flat();
  }

  const StoredArrays& image_;
};

// ---------------------------------------------------------------------------------------------
// What does not lie in memory as it is stored.

/// Supports as an array of kinds and one of entities: pairs would have padding, bytes without
/// meaning.
struct Supports {
  std::vector<std::uint8_t> kinds;
  std::vector<std::int32_t> entities;
};
Supports apart(const CowVector<Support>& supports) {
  Supports out;
  out.kinds.reserve(supports.size());
  out.entities.reserve(supports.size());
  supports.for_each([&](std::size_t, const Support& s) {
    out.kinds.push_back(static_cast<std::uint8_t>(s.kind));
    out.entities.push_back(s.entity);
  });
  return out;
}
CowVector<Support> together(const Supports& parts, const CowVector<Support>* alike) {
  if (parts.kinds.size() != parts.entities.size())
    throw error::internal("store", "supports without a kind");
  std::vector<Support> all(parts.kinds.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = {static_cast<Support::Kind>(parts.kinds[i]), parts.entities[i]};
  return alike ? CowVector<Support>(std::span<const Support>(all), *alike)
               : CowVector<Support>(all);
}
void write_supports(Writer& write, const std::string& name, const CowVector<Support>& supports,
                    const std::string& like = {}) {
  const Supports parts = apart(supports);
  write((name + ".kind").c_str(), parts.kinds, like.empty() ? "" : like + ".kind");
  write((name + ".entity").c_str(), parts.entities, like.empty() ? "" : like + ".entity");
}
CowVector<Support> read_supports(const Reader& read, const std::string& name,
                                 const CowVector<Support>* alike) {
  Supports parts;
  read((name + ".kind").c_str(), parts.kinds);
  read((name + ".entity").c_str(), parts.entities);
  return together(parts, alike);
}

/// For each cavity: how many slots it has, how many output tets, then the slots, then the tets.
std::vector<std::int32_t> flattened(const CowVector<Cavity>& cavities) {
  std::vector<std::int32_t> flat;
  cavities.for_each([&](std::size_t, const Cavity& c) {
    flat.push_back(static_cast<std::int32_t>(c.delaunay.size()));
    flat.push_back(static_cast<std::int32_t>(c.output.size()));
    flat.insert(flat.end(), c.delaunay.begin(), c.delaunay.end());
    flat.insert(flat.end(), c.output.begin(), c.output.end());
  });
  return flat;
}
CowVector<Cavity> unflattened(const std::vector<std::int32_t>& flat,
                              const CowVector<Cavity>* alike) {
  std::vector<Cavity> cavities;
  std::size_t at = 0;
  const auto take = [&](std::int32_t count) {
    if (count < 0 || flat.size() - at < static_cast<std::size_t>(count))
      throw error::internal("store", "a cluster is cut off");
    const auto begin = flat.begin() + static_cast<std::ptrdiff_t>(at);
    at += static_cast<std::size_t>(count);
    return std::vector<std::int32_t>(begin, begin + count);
  };
  while (at < flat.size()) {
    const std::vector<std::int32_t> sizes = take(2);
    Cavity cavity;
    cavity.delaunay = take(sizes[0]);
    cavity.output = take(sizes[1]);
    cavities.push_back(std::move(cavity));
  }
  return alike ? CowVector<Cavity>(std::span<const Cavity>(cavities), *alike)
               : CowVector<Cavity>(cavities);
}

void write_facets(Writer& write, const std::vector<MeshFacet>& facets) {
  std::vector<Triangle> nodes;
  std::vector<std::int32_t> tets, groups;
  for (const MeshFacet& f : facets) {
    nodes.push_back(f.nodes);
    tets.push_back(f.tet);
    groups.push_back(f.group);
  }
  write("delivery.facets", nodes);
  write("delivery.facet_tets", tets);
  write("delivery.facet_group", groups);
}
std::vector<MeshFacet> read_facets(const Reader& read) {
  std::vector<Triangle> nodes;
  std::vector<std::int32_t> tets, groups;
  read("delivery.facets", nodes);
  read("delivery.facet_tets", tets);
  read("delivery.facet_group", groups);
  if (tets.size() != nodes.size() || groups.size() != nodes.size())
    throw error::internal("store", "facets without a tet or a group");
  std::vector<MeshFacet> facets(nodes.size());
  for (std::size_t i = 0; i < facets.size(); ++i) facets[i] = {nodes[i], tets[i], groups[i]};
  return facets;
}

/// A member of the revision, or of a part of it, to share memory with; null where there is none.
template <class Of, class T>
const T* member(const Of* of, T Of::*which) {
  return of != nullptr ? &(of->*which) : nullptr;
}

void read_output(const Reader& read, const OutputMesh* alike, OutputMesh& d) {
  const PagedMesh* mesh = member(alike, &OutputMesh::mesh);
  const NodeMap* map = member(alike, &OutputMesh::map);
  read("delivery.nodes", d.mesh.nodes, member(mesh, &PagedMesh::nodes));
  read("delivery.tets", d.mesh.tets, member(mesh, &PagedMesh::tets));
  read("delivery.node_ids", d.node_ids, member(alike, &OutputMesh::node_ids));
  read("delivery.tet_ids", d.tet_ids, member(alike, &OutputMesh::tet_ids));
  d.groups.facets = read_facets(read);
  read("delivery.tet_cells", d.groups.tet_cell,
       member(member(alike, &OutputMesh::groups), &MeshGroups::tet_cell));
  read("delivery.node_origins", d.map.node_origin, member(map, &NodeMap::node_origin));
  read("delivery.original_nodes", d.map.original_node, member(map, &NodeMap::original_node));
  read("delivery.node_transforms", d.map.node_transform, member(map, &NodeMap::node_transform));
  read("delivery.original_tets", d.map.original_tet, member(map, &NodeMap::original_tet));
  read("delivery.transforms", d.map.transforms);
}

void write_mids(Writer& write, const MidNodes& m) {
  write("mids.nodes", m.positions);
  write("mids.edges", m.edges);
  write("mids.tets", m.of_tets);
  write("mids.ids", m.ids);
  write("mids.origins", m.origin);
  write("mids.originals", m.original);
  write("mids.transforms", m.transform);
  write("mids.straightened", m.straightened);
}
void read_mids(const Reader& read, const MidNodes* alike, MidNodes& m) {
  read("mids.nodes", m.positions, member(alike, &MidNodes::positions));
  read("mids.edges", m.edges, member(alike, &MidNodes::edges));
  read("mids.tets", m.of_tets, member(alike, &MidNodes::of_tets));
  read("mids.ids", m.ids, member(alike, &MidNodes::ids));
  read("mids.origins", m.origin, member(alike, &MidNodes::origin));
  read("mids.originals", m.original, member(alike, &MidNodes::original));
  read("mids.transforms", m.transform, member(alike, &MidNodes::transform));
  read("mids.straightened", m.straightened);
}

void read_delaunay_state(const Reader& read, const DelaunayState* alike, DelaunayState& state) {
  state.mesh.visit_named([&](const char* name, auto& values) {
    using Values = std::remove_reference_t<decltype(values)>;
    if constexpr (requires { typename Values::Iterator; }) {
      const Values* other = nullptr;
      if (alike != nullptr)
        alike->mesh.visit_named([&](const char* its_name, const auto& its) {
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(its)>, Values>)
            if (std::string_view(its_name) == name) other = &its;
        });
      read(name, values, other);
    } else {
      read(name, values);
    }
  });
  state.supports = read_supports(read, "master.supports", member(alike, &DelaunayState::supports));
  read("master.tet_of_slot", state.tet_of_slot, member(alike, &DelaunayState::tet_of_slot));
  std::vector<std::int32_t> cavities;
  read("master.clusters", cavities);
  state.cavities = unflattened(cavities, member(alike, &DelaunayState::cavities));
}

std::shared_ptr<const Anchor> read_anchor(const Reader& read, const Anchor* alike,
                                          ModelSource source) {
  Anchor anchor;
  anchor.source = std::move(source);
  read("anchor.nodes", anchor.nodes, member(alike, &Anchor::nodes));
  anchor.supports = read_supports(read, "anchor.supports", member(alike, &Anchor::supports));
  anchor.model = evaluate(anchor.source);
  return std::make_shared<const Anchor>(std::move(anchor));
}

}  // namespace

StoredArrays image_of(const Revision& revision) {
  Writer write;
  const OutputMesh& d = revision.output;
  write("delivery.nodes", d.mesh.nodes);
  write("delivery.tets", d.mesh.tets);
  write("delivery.node_ids", d.node_ids);
  write("delivery.tet_ids", d.tet_ids);
  write_facets(write, d.groups.facets);
  write("delivery.tet_cells", d.groups.tet_cell);
  write("delivery.node_origins", d.map.node_origin);
  write("delivery.original_nodes", d.map.original_node);
  write("delivery.node_transforms", d.map.node_transform);
  write("delivery.original_tets", d.map.original_tet);
  write("delivery.transforms", d.map.transforms);
  const DelaunayState& m = *revision.delaunay_state;
  m.mesh.visit_named([&](const char* name, const auto& values) { write(name, values); });
  write_supports(write, "master.supports", m.supports);
  write("master.tet_of_slot", m.tet_of_slot);
  write("master.clusters", flattened(m.cavities));
  if (const Anchor* anchor = revision.anchor.get()) {
    // In the first revision that has this anchor, these equal the base's arrays named as `like`.
    write("anchor.nodes", anchor->nodes, "delivery.nodes");
    write_supports(write, "anchor.supports", anchor->supports, "master.supports");
  }
  if (!d.node_sizes.empty()) write(kNodeSizes, d.node_sizes);
  if (revision.options.order == 2) write_mids(write, d.mids);
  write.bytes(kDocuments, write_documents(revision));
  return write.take();
}

Revision revision_of(const StoredArrays& image, const Revision* alike, const Run& run) {
  if (const StoredArray* whole = image.find(kOlderBytes)) {
    Revision older = read_older_format(whole->flat(), run);
    older.report.figures = group_figures(older);  // it has none stored
    return older;
  }
  const Reader read(image);
  Revision revision;
  Documents documents = read_documents(read.bytes(kDocuments), revision);
  read_output(read, member(alike, &Revision::output), revision.output);
  if (image.find(kNodeSizes) != nullptr)
    read(kNodeSizes, revision.output.node_sizes,
         member(member(alike, &Revision::output), &OutputMesh::node_sizes));
  if (revision.options.order == 2)
    read_mids(read, member(member(alike, &Revision::output), &OutputMesh::mids),
              revision.output.mids);
  DelaunayState state = std::move(documents.delaunay_state);
  read_delaunay_state(read, alike ? alike->delaunay_state.get() : nullptr, state);
  if (documents.anchored)
    revision.anchor = read_anchor(read, alike ? alike->anchor.get() : nullptr,
                                  std::move(documents.anchor_source));
  revision.model = evaluate(without_tiny_motions(revision.source, revision.meshed_source).source);
  revision.meshed_model = evaluate(revision.meshed_source);
  check_parts(documents.parts, revision.model);
  revision.cells = restore_cells(revision.model, std::move(documents.parts));
  revision.delaunay_state = std::make_shared<const DelaunayState>(std::move(state));
  check_indices(revision);
  revision.output.groups.of_model = group_members(revision.output, revision.model);
  if (!documents.has_figures) revision.report.figures = group_figures(revision);
  revision.boxes = boxes_round(revision.output.mesh);
  revision.measures = measure_tets(revision.output.mesh.nodes, revision.output.mesh.tets, run);
  return revision;
}

}  // namespace remeshd
