// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "client/formats/element_nodes.h"
#include "client/formats/element_types.h"
#include "client/formats/named_groups.h"
#include "client/formats/text.h"
#include "remeshd/mesh_file.h"

namespace remeshd::client {
namespace {

template <class T>
void put(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// The entities of one dimension, in ascending order of cell or facet group, then of the groups of
/// the model: entity k has the tag k + 1.
struct Entities {
  std::int32_t dimension = 0;
  std::vector<std::vector<std::int32_t>> physical;  ///< physical tags of each entity, its own first
  std::vector<std::string> names;                   ///< of physical tag offset + index + 1
  std::int32_t offset = 0;
  std::vector<std::array<double, 6>> boxes;
  std::vector<std::vector<std::size_t>> elements;  ///< indices of tets or facets, ascending
};

/// What the elements of an entity have in common: a cell or facet group, and the groups of the
/// model that they are in, ascending.
struct EntityKey {
  std::int32_t group = 0;
  std::vector<std::int32_t> of_model;
  friend auto operator<=>(const EntityKey&, const EntityKey&) = default;
};

/// Names of physical groups, and the tags of those that each cell or facet group is in, its own
/// first. Tags begin after `offset`, so that surfaces and volumes have different ones: formats with
/// one kind of groups, such as UNV, would merge groups of the same number.
struct PhysicalNames {
  std::int32_t offset = 0;
  std::vector<std::string> names;  ///< of tag offset + index + 1
  std::vector<std::vector<std::int32_t>> of_group;

  std::int32_t add(const std::string& name) {
    names.push_back(name);
    return offset + static_cast<std::int32_t>(names.size());
  }
};

PhysicalNames physical_names(const std::vector<std::vector<std::string>>& groups,
                             std::size_t offset) {
  PhysicalNames out;
  out.offset = static_cast<std::int32_t>(offset);
  for (const auto& names : groups) out.of_group.push_back({out.add(joined(names))});
  for (const NamedGroups& single : by_name(groups)) {
    const bool stands_alone =
        single.groups.size() == 1 && groups[static_cast<std::size_t>(single.groups[0])].size() == 1;
    if (stands_alone) continue;
    // The group that carries this name alone lends its physical group to all that share the name.
    std::int32_t tag = 0;
    for (const std::int32_t g : single.groups)
      if (groups[static_cast<std::size_t>(g)].size() == 1) tag = out.offset + g + 1;
    if (tag == 0) tag = out.add(single.name);
    for (const std::int32_t g : single.groups)
      if (out.offset + g + 1 != tag) out.of_group[static_cast<std::size_t>(g)].push_back(tag);
  }
  return out;
}

/// Sorts elements, each with its key, into entities. A cell or facet group without elements gets an
/// empty entity, so that it keeps its physical group.
Entities entities(std::int32_t dimension, std::size_t offset,
                  const std::vector<std::vector<std::string>>& groups,
                  const std::vector<std::string>& of_model, const std::vector<EntityKey>& keys) {
  Entities out;
  out.dimension = dimension;
  PhysicalNames physical = physical_names(groups, offset);
  out.offset = physical.offset;
  std::vector<std::int32_t> model_tags;
  std::vector<bool> used(of_model.size(), false);
  for (const EntityKey& key : keys)
    for (const std::int32_t g : key.of_model) used[static_cast<std::size_t>(g)] = true;
  for (std::size_t g = 0; g < of_model.size(); ++g)
    model_tags.push_back(used[g] ? physical.add(of_model[g]) : 0);
  std::map<EntityKey, std::vector<std::size_t>> by_key;
  for (std::size_t k = 0; k < keys.size(); ++k) by_key[keys[k]].push_back(k);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto first = by_key.lower_bound({static_cast<std::int32_t>(g), {}});
    if (first == by_key.end() || first->first.group != static_cast<std::int32_t>(g))
      by_key[{static_cast<std::int32_t>(g), {}}];
  }
  for (auto& [key, elements] : by_key) {
    std::vector<std::int32_t> tags = physical.of_group[static_cast<std::size_t>(key.group)];
    for (const std::int32_t g : key.of_model)
      tags.push_back(model_tags[static_cast<std::size_t>(g)]);
    out.physical.push_back(std::move(tags));
    out.elements.push_back(std::move(elements));
  }
  out.names = std::move(physical.names);
  return out;
}

/// Bounding boxes of the entities; `corners_of(element)`: its corner nodes.
template <class CornersOf>
void find_boxes(Entities& list, const Mesh& mesh, const CornersOf& corners_of) {
  for (const auto& elements : list.elements) {
    std::array<double, 6>& box = list.boxes.emplace_back();
    bool first = true;
    for (const std::size_t element : elements)
      for (const std::int32_t corner : corners_of(element)) {
        const auto& node = mesh.nodes[static_cast<std::size_t>(corner)];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          box[axis] = first ? node[axis] : std::fmin(box[axis], node[axis]);
          box[3 + axis] = first ? node[axis] : std::fmax(box[3 + axis], node[axis]);
        }
        first = false;
      }
  }
}

/// The keys of facets or tets: `group_of` each, and the groups of the model that it is in.
template <class GroupOf>
std::vector<EntityKey> keys_of(std::size_t count, const GroupOf& group_of,
                               const std::vector<std::array<std::int32_t, 2>>& members) {
  std::vector<EntityKey> keys(count);
  for (std::size_t k = 0; k < count; ++k) keys[k].group = group_of(k);
  for (const auto& [group, member] : members)
    keys[static_cast<std::size_t>(member)].of_model.push_back(group);
  return keys;
}

void write_names(std::string& out, const Entities& list) {
  for (std::size_t k = 0; k < list.names.size(); ++k) {
    append(out, list.dimension);
    out += ' ';
    append(out, static_cast<std::size_t>(list.offset) + k + 1);
    out.append(" \"").append(list.names[k]).append("\"\n");
  }
}

void write_entities(std::string& out, const Entities& list) {
  for (std::size_t k = 0; k < list.physical.size(); ++k) {
    put(out, static_cast<std::int32_t>(k + 1));
    for (const double bound : list.boxes[k]) put(out, bound);
    put(out, std::uint64_t{list.physical[k].size()});
    for (const std::int32_t tag : list.physical[k]) put(out, tag);
    put(out, std::uint64_t{0});  // bounding entities: not told
  }
}

std::uint64_t filled(const Entities& list) {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(list.elements, [](const auto& e) { return !e.empty(); }));
}

template <class NodesOf>
void write_elements(std::string& out, const Entities& list, std::int32_t type,
                    std::uint64_t first_tag, const NodesOf& nodes_of_element) {
  for (std::size_t k = 0; k < list.elements.size(); ++k) {
    if (list.elements[k].empty()) continue;
    put(out, list.dimension);
    put(out, static_cast<std::int32_t>(k + 1));
    put(out, type);
    put(out, std::uint64_t{list.elements[k].size()});
    for (const std::size_t element : list.elements[k]) {
      put(out, first_tag + element);
      for (const std::int32_t node : nodes_of_element(element))
        put(out, static_cast<std::uint64_t>(node) + 1);
    }
  }
}

/// Gmsh has the mid-nodes of the edges 13 and 23 the other way round.
std::vector<std::int32_t> in_gmsh_order(std::vector<std::int32_t> nodes) {
  if (nodes.size() == 10) std::swap(nodes[8], nodes[9]);
  return nodes;
}

/// The edge lengths aimed at, as a post-processing view of all nodes (readers refuse one of some).
void write_sizes(std::string& out, const Mesh& mesh) {
  const std::vector<double> sizes = sizes_of(mesh);
  if (sizes.empty()) return;
  constexpr std::int32_t kStep = 0, kComponents = 1;
  out += "$NodeData\n1\n\"size\"\n1\n0\n3\n";  // its name, its time, three numbers
  append(out, kStep);
  out += '\n';
  append(out, kComponents);
  out += '\n';
  append(out, sizes.size());
  out += '\n';
  for (std::size_t n = 0; n < sizes.size(); ++n) {
    put(out, static_cast<std::int32_t>(n + 1));
    put(out, sizes[n]);
  }
  out += "\n$EndNodeData\n";
}

}  // namespace

std::string to_msh(const Mesh& mesh) {
  Entities surfaces =
      entities(2, 0, mesh.facet_groups, mesh.group_names,
               keys_of(
                   mesh.facets.size(), [&](std::size_t f) { return mesh.facets[f].group; },
                   mesh.group_facets));
  find_boxes(surfaces, mesh, [&](std::size_t f) { return mesh.facets[f].nodes; });
  Entities volumes = entities(
      3, surfaces.names.size(), mesh.cell_owners, mesh.group_names,
      keys_of(
          mesh.tets.size(), [&](std::size_t t) { return mesh.tet_cell[t]; }, mesh.group_tets));
  find_boxes(volumes, mesh, [&](std::size_t t) { return mesh.tets[t]; });

  std::string out = "$MeshFormat\n4.1 1 8\n";
  put(out, std::int32_t{1});  // tells the byte order
  out += "\n$EndMeshFormat\n$Comments\n";
  for (const std::string& line : provenance(mesh)) out.append(line).append("\n");
  out += "$EndComments\n$PhysicalNames\n";
  append(out, surfaces.names.size() + volumes.names.size());
  out += '\n';
  write_names(out, surfaces);
  write_names(out, volumes);
  out += "$EndPhysicalNames\n$Entities\n";
  put(out, std::uint64_t{0});
  put(out, std::uint64_t{0});
  put(out, std::uint64_t{surfaces.physical.size()});
  put(out, std::uint64_t{volumes.physical.size()});
  write_entities(out, surfaces);
  write_entities(out, volumes);

  // One block keeps the nodes in their order for readers that go by place, not by tag.
  out += "\n$EndEntities\n$Nodes\n";
  const std::uint64_t nodes = mesh.nodes.size() + mesh.mid_nodes.size();
  const std::uint64_t none = 0;
  const std::uint64_t one = 1;
  put(out, nodes > 0 ? one : none);
  put(out, nodes);
  put(out, nodes > 0 ? one : none);
  put(out, nodes);
  if (nodes > 0) {
    put(out, std::int32_t{3});  // dimension of the entity
    put(out, std::int32_t{1});  // its tag
    put(out, std::int32_t{0});  // no parametric coordinates
    put(out, nodes);
    for (std::uint64_t tag = 1; tag <= nodes; ++tag) put(out, tag);
    for (const auto* list : {&mesh.nodes, &mesh.mid_nodes})
      for (const auto& node : *list)
        for (const double coordinate : node) put(out, coordinate);
  }

  out += "\n$EndNodes\n$Elements\n";
  const std::uint64_t elements = mesh.tets.size() + mesh.facets.size();
  put(out, filled(surfaces) + filled(volumes));
  put(out, elements);
  put(out, elements > 0 ? one : none);
  put(out, elements);
  const bool second = is_second_order(mesh);
  write_elements(out, surfaces, second ? kGmshTriangle6 : kGmshTriangle, 1 + mesh.tets.size(),
                 [&](std::size_t f) { return nodes_of(mesh, mesh.facets[f]); });
  write_elements(out, volumes, second ? kGmshTetrahedron10 : kGmshTetrahedron, 1,
                 [&](std::size_t t) { return in_gmsh_order(nodes_of(mesh, t)); });
  out += "\n$EndElements\n";
  write_sizes(out, mesh);
  return out;
}

}  // namespace remeshd::client
