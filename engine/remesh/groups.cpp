#include "engine/remesh/groups.h"

#include <algorithm>
#include <map>

#include "engine/improve/boundary_rules.h"
#include "engine/remesh/facet_names.h"

namespace remeshd {

namespace {

Vec3 centroid(const TetMesh& mesh, const Tet& t) {
  return 0.25 * (mesh.nodes[t[0]] + mesh.nodes[t[1]] + mesh.nodes[t[2]] + mesh.nodes[t[3]]);
}

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
void owners_of(const TetMesh& mesh, const Tet& t, const FeatureModel& model,
               const Membership& membership, std::vector<int>& owners) {
  const auto look = [&](const Vec3& p) {
    owners.clear();
    membership.owners(p, owners);
    return !owners.empty() && model.features[owners.back()].nature == Nature::Additive;
  };
  const Vec3 c = centroid(mesh, t);
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

}  // namespace

MeshGroups name_groups(const TetMesh& mesh, std::span<const SurfaceFacet> surface,
                       std::span<const Support> supports, const FeatureModel& model,
                       const Membership& membership, const BoundaryModel& boundary,
                       const CellsBefore& before, const Run& run) {
  MeshGroups groups;
  Numbering<std::vector<int>> cells;
  groups.tet_cell.assign(mesh.tets.size(), -1);
  Polling poll(run);
  if (before.groups) {
    const std::vector<std::int32_t>& then = before.groups->tet_cell;
    std::vector<std::int32_t> number(before.groups->cell_owners.size(), -1);
    std::size_t next = 0;
    for (std::size_t k = 0; k < mesh.tets.size(); ++k) {
      if (next < before.others.size() && before.others[next] == static_cast<std::int32_t>(k)) {
        ++next;
        continue;
      }
      std::int32_t& cell = number[then[k]];
      if (cell < 0) cell = cells(indices_of(before.groups->cell_owners[then[k]], model));
      groups.tet_cell[k] = cell;
    }
  }
  std::vector<int> owners;
  std::vector<int> last;  // neighbours in order are mostly neighbours in space: the same cell again
  std::int32_t last_cell = -1;
  for (std::size_t k = 0; k < mesh.tets.size(); ++k) {
    poll();
    if (groups.tet_cell[k] >= 0) continue;
    owners_of(mesh, mesh.tets[k], model, membership, owners);
    if (last_cell < 0 || owners != last) {
      last_cell = cells(owners);
      last = owners;
    }
    groups.tet_cell[k] = last_cell;
  }
  std::vector<std::int32_t> renumber;
  for (const std::vector<int>& cell : cells.sorted(renumber)) {
    std::vector<std::string> ids;
    for (const int feature : cell) ids.push_back(model.features[feature].id);
    groups.cell_owners.push_back(std::move(ids));
  }
  for (std::int32_t& c : groups.tet_cell) c = renumber[c];

  const FacetFaces faces(boundary, supports);
  const FacetNames names(model, membership, boundary);
  Numbering<std::vector<std::string>> facet_groups;
  std::vector<std::int32_t> of_face(boundary.faces.size(), -1);  // faces with one name throughout
  groups.facets.reserve(surface.size());
  for (const SurfaceFacet& f : surface) {
    poll();
    const int face = faces.face_of(f.nodes, mesh.nodes);
    std::int32_t group = face >= 0 ? of_face[face] : facet_groups({});
    if (group < 0) {
      group = facet_groups(names(
          face, (mesh.nodes[f.nodes[0]] + mesh.nodes[f.nodes[1]] + mesh.nodes[f.nodes[2]]) / 3.0));
      if (boundary.faces[face].names.size() == 1) of_face[face] = group;
    }
    groups.facets.push_back({f.nodes, f.tet, group});
  }
  groups.facet_groups = facet_groups.sorted(renumber);
  for (MeshFacet& f : groups.facets) f.group = renumber[f.group];
  return groups;
}

}  // namespace remeshd
