// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "client/formats/element_nodes.h"
#include "client/formats/inp_head.h"
#include "client/formats/named_groups.h"
#include "client/formats/text.h"
#include "remeshd/mesh_file.h"

namespace remeshd::client {
namespace {

/// Abaqus's number of the facet of a C3D4 or C3D10 opposite each corner: S1 is 1-2-3, S2 1-4-2, S3
/// 2-4-3, S4 3-4-1.
constexpr std::array<int, 4> kFaceNumber{3, 4, 2, 1};

/// A coordinate that reads back to the same bits. Without an exponent where that can be: CalculiX
/// looks at the first 20 characters of a number only, and there a cut fraction is harmless (it
/// moves a node by less than 1e-17) while a cut exponent is an error.
void append_coordinate(std::string& out, double value) {
  const double size = std::fabs(value);
  const bool plain = size == 0 || (size > 1e-60 && size < 1e16);
  const std::size_t start = out.size();
  append(out, value, plain ? std::chars_format::fixed : std::chars_format::scientific);
  if (out.find('.', start) == std::string::npos && plain) out += ".0";
}

/// Labels of one kind of set: valid and different for Abaqus, which folds case.
class Labels {
 public:
  /// A label for a feature or face name; the same name must not be asked for twice.
  std::string make(const std::string& name) {
    std::string label = name;
    std::ranges::replace(label, '.', '_');
    std::string candidate = label;
    for (int k = 2; !taken_.insert(folded(candidate)).second; ++k)
      candidate = label + "_" + std::to_string(k);
    return candidate;
  }

 private:
  static std::string folded(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
  }
  std::set<std::string> taken_;
};

/// Numbers as data lines of at most 16 entries, the limit of both programs.
template <class Numbers>
void append_numbers(std::string& out, const Numbers& numbers) {
  std::size_t on_line = 0;
  for (const auto number : numbers) {
    if (on_line == 16) {
      out += ",\n";
      on_line = 0;
    }
    if (on_line > 0) out += ", ";
    append(out, number);
    ++on_line;
  }
  out += '\n';
}

std::size_t corner_opposite(const Mesh& mesh, const Facet& facet) {
  const auto& tet = mesh.tets[static_cast<std::size_t>(facet.tet)];
  std::size_t corner = 0;
  while (std::ranges::find(facet.nodes, tet[corner]) != facet.nodes.end()) ++corner;
  return corner;
}

/// An element set, with a line that tells its name as it is.
void append_tets(std::string& out, const char* what, const std::string& name,
                 const std::vector<std::size_t>& tets, Labels& labels) {
  if (tets.empty()) return;
  out.append("** ").append(what).append(" ").append(name).append("\n*ELSET, ELSET=");
  out.append(labels.make(name)).append("\n");
  append_numbers(out, tets);
}

/// A node set and a surface of facets.
void append_facets(std::string& out, const char* what, const std::string& name,
                   const std::vector<std::size_t>& facets, const Mesh& mesh, Labels& labels) {
  if (facets.empty()) return;
  std::set<std::int32_t> nodes;
  std::string sides;
  for (const std::size_t f : facets) {
    const Facet& facet = mesh.facets[f];
    for (const std::int32_t node : nodes_of(mesh, facet)) nodes.insert(node + 1);
    append(sides, facet.tet + 1);
    sides += ", S";
    append(sides, kFaceNumber[corner_opposite(mesh, facet)]);
    sides += '\n';
  }
  const std::string label = labels.make(name);
  out.append("** ").append(what).append(" ").append(name).append("\n*NSET, NSET=");
  out.append(label).append("\n");
  append_numbers(out, nodes);
  out.append("*SURFACE, NAME=").append(label).append(", TYPE=ELEMENT\n").append(sides);
}

/// Labels of a file: those of nodes and surfaces, and those of elements.
struct SetLabels {
  Labels faces, elements;
};

/// Appended before features and faces, so that of equal labels the groups' are those without a
/// suffix.
void append_groups(std::string& out, const Mesh& mesh, SetLabels& labels) {
  for (const ModelGroup& group : model_groups(mesh)) {
    append_facets(out, "group", group.name, {group.facets.begin(), group.facets.end()}, mesh,
                  labels.faces);
    std::vector<std::size_t> tets;
    for (const std::int32_t t : group.tets) tets.push_back(static_cast<std::size_t>(t) + 1);
    append_tets(out, "group", group.name, tets, labels.elements);
  }
}

/// Label of the sets of everything. No group of the model has it, whatever it holds: a load on a
/// group that has lost its facets must not act on all nodes.
std::string label_of_all(const Mesh& mesh) {
  Labels of_groups;
  for (const std::string& name : mesh.group_names) of_groups.make(name);
  return of_groups.make(kAllName);
}

/// All elements and all nodes, for materials and for what CalculiX asks a set for.
void append_all(std::string& out, const Mesh& mesh, SetLabels& labels) {
  if (mesh.tets.empty()) return;
  const auto append_range = [&out](const char* set, const std::string& label, std::size_t last) {
    out.append(set).append(label).append(", GENERATE\n1, ");
    append(out, last);
    out += ", 1\n";  // meshio wants the step
  };
  const std::string label = label_of_all(mesh);
  append_range("*ELSET, ELSET=", labels.elements.make(label), mesh.tets.size());
  append_range("*NSET, NSET=", labels.faces.make(label), mesh.nodes.size() + mesh.mid_nodes.size());
}

void append_owners(std::string& out, const Mesh& mesh, Labels& labels) {
  for (const NamedGroups& owner : by_name(mesh.cell_owners)) {
    std::vector<std::size_t> tets;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      if (std::ranges::binary_search(owner.groups, mesh.tet_cell[t])) tets.push_back(t + 1);
    append_tets(out, "feature", owner.name, tets, labels);
  }
}

void append_faces(std::string& out, const Mesh& mesh, Labels& labels) {
  for (const NamedGroups& face : by_name(mesh.facet_groups)) {
    std::vector<std::size_t> facets;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f)
      if (std::ranges::binary_search(face.groups, mesh.facets[f].group)) facets.push_back(f);
    append_facets(out, "face", face.name, facets, mesh, labels);
  }
}

}  // namespace

std::string to_inp(const Mesh& mesh) {
  std::string out = "*HEADING\ntetrahedral mesh by remeshd\n";
  // By these counts `parse_inp` finds that a file was cut at the end of a line.
  out += kInpHead;
  append(out, mesh.nodes.size() + mesh.mid_nodes.size());
  out += ", ";
  append(out, mesh.tets.size());
  out += '\n';
  for (const std::string& line : provenance(mesh)) out.append("** ").append(line).append("\n");
  out += "*NODE\n";
  std::size_t number = 0;
  for (const auto* nodes : {&mesh.nodes, &mesh.mid_nodes})
    for (const auto& node : *nodes) {
      append(out, ++number);
      for (const double coordinate : node) {
        out += ", ";
        append_coordinate(out, coordinate);
      }
      out += '\n';
    }
  out += is_second_order(mesh) ? "*ELEMENT, TYPE=C3D10\n" : "*ELEMENT, TYPE=C3D4\n";
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    append(out, t + 1);
    for (const std::int32_t node : nodes_of(mesh, t)) {
      out += ", ";
      append(out, node + 1);
    }
    out += '\n';
  }
  SetLabels labels;
  append_all(out, mesh, labels);
  append_groups(out, mesh, labels);
  append_owners(out, mesh, labels.elements);
  append_faces(out, mesh, labels.faces);
  return out;
}

}  // namespace remeshd::client
