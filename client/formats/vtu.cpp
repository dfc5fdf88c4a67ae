// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>
#include <ranges>
#include <string_view>

#include "client/formats/element_nodes.h"
#include "client/formats/element_types.h"
#include "client/formats/named_groups.h"
#include "client/formats/text.h"
#include "remeshd/mesh_file.h"

namespace remeshd::client {
namespace {

static_assert(std::endian::native == std::endian::little, "raw arrays are written as they lie");

template <class T>
constexpr std::string_view kVtkType = "";
template <>
constexpr std::string_view kVtkType<double> = "Float64";
template <>
constexpr std::string_view kVtkType<std::uint8_t> = "UInt8";
template <>
constexpr std::string_view kVtkType<std::int32_t> = "Int32";
template <>
constexpr std::string_view kVtkType<std::int64_t> = "Int64";
template <>
constexpr std::string_view kVtkType<std::uint64_t> = "UInt64";

struct Array {
  std::string section;  ///< FieldData, PointData, CellData, Points or Cells
  std::string name;
  std::string_view type;
  int components = 1;
  std::size_t tuples = 0;
  std::string bytes;
  std::size_t offset = 0;
};

class Arrays {
 public:
  template <class T>
  void add(const std::string& section, const std::string& name, int components,
           const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    list_.push_back({section, name, kVtkType<T>, components,
                     values.size() / static_cast<std::size_t>(components), std::move(bytes)});
  }

  /// The offsets run against the order of the document: meshio, which rewrites offsets one by one
  /// while it looks arrays up by them, can then never take one for another.
  void place() {
    std::size_t at = 0;
    for (Array& array : std::views::reverse(list_)) {
      array.offset = at;
      at += sizeof(std::uint64_t) + array.bytes.size();
    }
  }

  void write_tags(std::string& out, std::string_view section) const {
    for (const Array& array : list_) {
      if (array.section != section) continue;
      out.append("        <DataArray type=\"").append(array.type).append("\" Name=\"");
      out.append(array.name).append("\"");
      if (section == "FieldData") {
        out += " NumberOfTuples=\"";
        append(out, array.tuples);
        out += '"';
      }
      if (array.components > 1) {
        out += " NumberOfComponents=\"";
        append(out, array.components);
        out += '"';
      }
      out += " format=\"appended\" offset=\"";
      append(out, array.offset);
      out += "\"/>\n";
    }
  }

  void write_data(std::string& out) const {
    for (const Array& array : std::views::reverse(list_)) {
      const std::uint64_t size = array.bytes.size();
      out.append(reinterpret_cast<const char*>(&size), sizeof size);
      out += array.bytes;
    }
  }

 private:
  std::vector<Array> list_;
};

/// What corner nodes have, then what mid-nodes have.
template <class T>
std::vector<T> joined(std::vector<T> corners, const std::vector<T>& mids) {
  corners.insert(corners.end(), mids.begin(), mids.end());
  return corners;
}

void add_point_data(Arrays& arrays, const Mesh& mesh) {
  std::vector<std::uint8_t> origin;
  for (const NodeOrigin o : joined(mesh.node_origin, mesh.mid_node_origin))
    origin.push_back(static_cast<std::uint8_t>(o));
  arrays.add("PointData", "origin", 1, origin);
  arrays.add("PointData", "original_node", 1, joined(mesh.original_node, mesh.original_mid_node));
  arrays.add("PointData", "transform", 1, joined(mesh.node_transform, mesh.mid_node_transform));
  arrays.add("PointData", "node_id", 1, joined(mesh.node_ids, mesh.mid_node_ids));
  if (!mesh.node_sizes.empty()) arrays.add("PointData", "size", 1, sizes_of(mesh));
}

void add_cell_data(Arrays& arrays, const Mesh& mesh) {
  std::vector<std::uint8_t> kept;
  for (const std::int32_t original : mesh.original_tet) kept.push_back(original >= 0 ? 1 : 0);
  arrays.add("CellData", "kept", 1, kept);
  arrays.add("CellData", "original_tet", 1, mesh.original_tet);
  arrays.add("CellData", "tet_id", 1, mesh.tet_ids);
  arrays.add("CellData", "cell", 1, mesh.tet_cell);

  for (const NamedGroups& owner : by_name(mesh.cell_owners)) {
    std::vector<std::uint8_t> owned(mesh.tets.size(), 0);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      owned[t] = std::ranges::binary_search(owner.groups, mesh.tet_cell[t]) ? 1 : 0;
    arrays.add("CellData", "owner:" + owner.name, 1, owned);
  }

  std::vector<std::int32_t> sides(4 * mesh.tets.size(), -1);
  for (const Facet& facet : mesh.facets) {
    const auto& tet = mesh.tets[static_cast<std::size_t>(facet.tet)];
    for (std::size_t corner = 0; corner < 4; ++corner)
      if (std::ranges::find(facet.nodes, tet[corner]) == facet.nodes.end())
        sides[4 * static_cast<std::size_t>(facet.tet) + corner] = facet.group;
  }
  std::vector<std::int32_t> first(mesh.tets.size(), -1);
  for (std::size_t t = 0; t < first.size(); ++t)
    for (std::size_t corner = 4; corner-- > 0;)
      if (sides[4 * t + corner] >= 0) first[t] = sides[4 * t + corner];
  arrays.add("CellData", "facet_groups", 4, sides);
  arrays.add("CellData", "face_group", 1, first);
}

void add_field_data(Arrays& arrays, const Mesh& mesh) {
  for (const NamedGroups& face : by_name(mesh.facet_groups))
    arrays.add("FieldData", "face:" + face.name, 1, face.groups);
  for (std::size_t k = 0; k < mesh.transforms.size(); ++k) {
    std::string name = "transform:";
    append(name, k);
    arrays.add("FieldData", name, 1,
               std::vector<double>(mesh.transforms[k].begin(), mesh.transforms[k].end()));
  }
}

void add_geometry(Arrays& arrays, const Mesh& mesh) {
  std::vector<double> points;
  points.reserve(3 * (mesh.nodes.size() + mesh.mid_nodes.size()));
  for (const auto* nodes : {&mesh.nodes, &mesh.mid_nodes})
    for (const auto& node : *nodes) points.insert(points.end(), node.begin(), node.end());
  arrays.add("Points", "Points", 3, points);

  const bool second = is_second_order(mesh);
  const std::int64_t nodes = second ? 10 : 4;
  std::vector<std::int64_t> connectivity;
  connectivity.reserve(static_cast<std::size_t>(nodes) * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const std::int32_t node : nodes_of(mesh, t)) connectivity.push_back(node);
  arrays.add("Cells", "connectivity", 1, connectivity);
  std::vector<std::int64_t> offsets(mesh.tets.size());
  for (std::size_t t = 0; t < offsets.size(); ++t)
    offsets[t] = nodes * (static_cast<std::int64_t>(t) + 1);
  arrays.add("Cells", "offsets", 1, offsets);
  arrays.add("Cells", "types", 1,
             std::vector<std::uint8_t>(mesh.tets.size(), second ? kVtkQuadraticTetra : kVtkTetra));
}

}  // namespace

std::string to_vtu(const Mesh& mesh) {
  Arrays arrays;
  add_field_data(arrays, mesh);
  add_point_data(arrays, mesh);
  add_cell_data(arrays, mesh);
  add_geometry(arrays, mesh);
  arrays.place();

  std::string out =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "  <UnstructuredGrid>\n"
      "    <FieldData>\n";
  arrays.write_tags(out, "FieldData");
  out += "    </FieldData>\n    <Piece NumberOfPoints=\"";
  append(out, mesh.nodes.size() + mesh.mid_nodes.size());
  out += "\" NumberOfCells=\"";
  append(out, mesh.tets.size());
  out += "\">\n      <PointData Scalars=\"origin\">\n";
  arrays.write_tags(out, "PointData");
  out += "      </PointData>\n      <CellData Scalars=\"kept\">\n";
  arrays.write_tags(out, "CellData");
  out += "      </CellData>\n      <Points>\n";
  arrays.write_tags(out, "Points");
  out += "      </Points>\n      <Cells>\n";
  arrays.write_tags(out, "Cells");
  out +=
      "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n"
      "  <AppendedData encoding=\"raw\">\n_";
  arrays.write_data(out);
  out += "\n  </AppendedData>\n</VTKFile>\n";
  return out;
}

}  // namespace remeshd::client
