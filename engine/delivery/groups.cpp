#include "engine/delivery/groups.h"

#include <algorithm>
#include <map>

#include "engine/boundary/facet_faces.h"
#include "engine/delivery/facet_names.h"

namespace remeshd {

namespace {

/// Numbers keys as they come and renumbers them in ascending order at the end.
template <class Key>
class Numbering {
 public:
  std::int32_t operator()(const Key& key) {
    const auto [at, fresh] = numbers_.try_emplace(key, static_cast<std::int32_t>(numbers_.size()));
    return at->second;
  }
  /// The keys in ascending order; `renumber[old]` is a key's place among them.
  std::vector<Key> sorted(std::vector<std::int32_t>& renumber) const {
    std::vector<Key> keys;
    renumber.resize(numbers_.size());
    for (const auto& [key, number] : numbers_) {
      renumber[number] = static_cast<std::int32_t>(keys.size());
      keys.push_back(key);
    }
    return keys;
  }

 private:
  std::map<Key, std::int32_t> numbers_;
};

/// Owners of the cell that a tet is in: at its centroid or, where a chord has cut that off from the
/// material, nearer to one of its corners.
void owners_of(const PagedMesh& mesh, const Tet& t, const FeatureModel& model,
               const Membership& membership, std::vector<int>& owners) {
  const auto look = [&](const Vec3& p) {
    owners.clear();
    membership.owners(p, owners);
    return !owners.empty() && model.features[owners.back()].nature == Nature::Additive;
  };
  const Vec3 c = centroid(mesh.nodes, t);
  if (look(c)) return;
  for (const double share : {0.5, 0.9})
    for (const std::int32_t n : t)
      if (look((1 - share) * c + share * mesh.nodes[n])) return;
  look(c);
}

std::vector<int> indices_of(const std::vector<std::string>& ids, const FeatureModel& model) {
  std::vector<int> indices;
  for (const std::string& id : ids) indices.push_back(model.index_of(id));
  std::ranges::sort(indices);
  return indices;
}

/// Finds the cells that the tets are in, sorted by owners.
void name_cells(const PagedMesh& mesh, const FeatureModel& model, const Membership& membership,
                const CellsBefore& before, MeshGroups& groups, const Run& run) {
  Numbering<std::vector<int>> cells;
  Polling poll(run);
  std::vector<std::int32_t> number;  // by cell of the earlier mesh: its number here, -1: none yet
  // Calls f(tet, its earlier cell) for tets that are still in that, g(tet) for the others.
  const auto each = [&](auto&& f, auto&& g) {
    if (!before.groups) {
      for (std::size_t k = 0; k < mesh.tets.size(); ++k) g(k);
      return;
    }
    const CowVector<std::int32_t>& then = before.groups->tet_cell;
    std::size_t k = 0;
    for (const std::int32_t other : before.others) {
      for (; k < static_cast<std::size_t>(other); ++k) f(k, then[k]);
      g(k++);
    }
    for (; k < mesh.tets.size(); ++k) f(k, then[k]);
  };
  if (before.groups) number.assign(before.groups->cell_owners.size(), -1);
  std::vector<std::int32_t> found;  // by other tet: its cell
  std::vector<int> owners;
  std::vector<int> last;  // neighbours in order are mostly neighbours in space: the same cell again
  std::int32_t last_cell = -1;
  each(
      [&](std::size_t, std::int32_t then) {
        if (number[then] < 0)
          number[then] = cells(indices_of(before.groups->cell_owners[then], model));
      },
      [&](std::size_t k) {
        poll();
        owners_of(mesh, mesh.tets[k], model, membership, owners);
        if (last_cell < 0 || owners != last) {
          last_cell = cells(owners);
          last = owners;
        }
        found.push_back(last_cell);
      });
  std::vector<std::int32_t> renumber;
  for (const std::vector<int>& cell : cells.sorted(renumber)) {
    std::vector<std::string> ids;
    for (const int feature : cell) ids.push_back(model.features[feature].id);
    groups.cell_owners.push_back(std::move(ids));
  }
  if (before.groups) groups.tet_cell = before.groups->tet_cell;
  groups.tet_cell.resize(mesh.tets.size());
  for (std::int32_t& n : number) n = n < 0 ? -1 : renumber[n];
  bool as_before = true;
  for (std::size_t c = 0; c < number.size(); ++c)
    as_before = as_before && (number[c] < 0 || number[c] == static_cast<std::int32_t>(c));
  auto next = found.begin();
  const auto set_others = [&](std::size_t k) { groups.tet_cell.set(k, renumber[*next++]); };
  if (as_before && before.groups)
    for (const std::int32_t k : before.others) set_others(k);
  else
    each([&](std::size_t k, std::int32_t then) { groups.tet_cell.set(k, number[then]); },
         set_others);
}

}  // namespace

MeshGroups name_groups(const PagedMesh& mesh, std::span<const SurfaceFacet> surface,
                       const CowVector<Support>& supports, const FeatureModel& model,
                       const Membership& membership, const BoundaryModel& boundary,
                       const CellsBefore& before, const Run& run) {
  MeshGroups groups;
  name_cells(mesh, model, membership, before, groups, run);
  const std::vector<Support> on = supports.flat();
  const FacetFaces faces(boundary, on);
  const FacetNames names(model, membership, boundary);
  Numbering<std::vector<std::string>> facet_groups;
  std::vector<std::int32_t> of_face(boundary.faces.size(), -1);  // faces with one name throughout
  groups.facets.reserve(surface.size());
  Polling poll(run);
  for (const SurfaceFacet& f : surface) {
    poll();
    const Vec3 &a = mesh.nodes[f.nodes[0]], &b = mesh.nodes[f.nodes[1]],
               &c = mesh.nodes[f.nodes[2]];
    const int face = faces.face_of(f.nodes, a, b, c);
    std::int32_t group = face >= 0 ? of_face[face] : facet_groups({});
    if (group < 0) {
      group = facet_groups(names(face, (a + b + c) / 3.0));
      if (boundary.faces[face].names.size() == 1) of_face[face] = group;
    }
    groups.facets.push_back({f.nodes, f.tet, group});
  }
  std::vector<std::int32_t> renumber;
  groups.facet_groups = facet_groups.sorted(renumber);
  for (MeshFacet& f : groups.facets) f.group = renumber[f.group];
  return groups;
}

}  // namespace remeshd
