// SPDX-License-Identifier: Apache-2.0
#include <zlib.h>

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
  std::string bytes;  ///< as they stand in the file, with their header
  std::size_t offset = 0;
};

/// An array as VTK's zlib compressor writes it: number of blocks, size of one, size of the last if
/// it is not full, packed sizes; then the blocks.
std::string compressed(const std::string& bytes) {
  constexpr std::size_t kBlock = std::size_t{1} << 18;
  const std::size_t blocks = (bytes.size() + kBlock - 1) / kBlock;
  std::vector<std::uint64_t> header{blocks, kBlock, bytes.size() % kBlock};
  std::string packed;
  std::vector<Bytef> buffer(compressBound(kBlock));
  for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
    const std::size_t size = std::min(kBlock, bytes.size() - at);
    uLongf length = buffer.size();
    // Fails only where the buffer is too small.
    compress2(buffer.data(), &length, reinterpret_cast<const Bytef*>(bytes.data() + at), size,
              Z_BEST_SPEED);
    packed.append(reinterpret_cast<const char*>(buffer.data()), length);
    header.push_back(length);
  }
  std::string out(header.size() * sizeof header[0], '\0');
  std::memcpy(out.data(), header.data(), out.size());
  return out + packed;
}

class Arrays {
 public:
  template <class T>
  void add(const std::string& section, const std::string& name, int components,
           const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    list_.push_back({section, name, kVtkType<T>, components,
                     values.size() / static_cast<std::size_t>(components), compressed(bytes)});
  }

  /// The offsets run against the order of the document: meshio, which rewrites offsets one by one
  /// while it looks arrays up by them, can then never take one for another.
  void place() {
    std::size_t at = 0;
    for (Array& array : std::views::reverse(list_)) {
      array.offset = at;
      at += array.bytes.size();
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
    for (const Array& array : std::views::reverse(list_)) out += array.bytes;
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

/// Values of the tets, then `of_facets` for each boundary facet.
template <class T>
std::vector<T> with_facets(std::vector<T> of_tets, const Mesh& mesh, T of_facets,
                           std::size_t components = 1) {
  of_tets.resize(of_tets.size() + components * mesh.facets.size(), of_facets);
  return of_tets;
}

void add_cell_data(Arrays& arrays, const Mesh& mesh) {
  std::vector<std::uint8_t> kept;
  for (const std::int32_t original : mesh.original_tet) kept.push_back(original >= 0 ? 1 : 0);
  arrays.add("CellData", "kept", 1, with_facets<std::uint8_t>(kept, mesh, 0));
  arrays.add("CellData", "original_tet", 1, with_facets(mesh.original_tet, mesh, -1));
  arrays.add("CellData", "tet_id", 1, with_facets<std::uint64_t>(mesh.tet_ids, mesh, 0));
  arrays.add("CellData", "cell", 1, with_facets(mesh.tet_cell, mesh, -1));

  for (const NamedGroups& owner : by_name(mesh.cell_owners)) {
    std::vector<std::uint8_t> owned(mesh.tets.size(), 0);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      owned[t] = std::ranges::binary_search(owner.groups, mesh.tet_cell[t]) ? 1 : 0;
    arrays.add("CellData", "owner:" + owner.name, 1, with_facets<std::uint8_t>(owned, mesh, 0));
  }

  std::vector<std::int32_t> sides(4 * mesh.tets.size(), -1);
  std::vector<std::int32_t> faces(mesh.tets.size(), -1);
  for (const Facet& facet : mesh.facets) {
    faces.push_back(facet.group);
    const auto& tet = mesh.tets[static_cast<std::size_t>(facet.tet)];
    for (std::size_t corner = 0; corner < 4; ++corner)
      if (std::ranges::find(facet.nodes, tet[corner]) == facet.nodes.end())
        sides[4 * static_cast<std::size_t>(facet.tet) + corner] = facet.group;
  }
  arrays.add("CellData", "facet_groups", 4, with_facets(sides, mesh, -1, 4));
  arrays.add("CellData", "face", 1, faces);
  for (const ModelGroup& group : model_groups(mesh)) {
    std::vector<std::uint8_t> in(mesh.tets.size() + mesh.facets.size(), 0);
    for (const std::int32_t t : group.tets) in[static_cast<std::size_t>(t)] = 1;
    for (const std::int32_t f : group.facets)
      in[mesh.tets.size() + static_cast<std::size_t>(f)] = 1;
    arrays.add("CellData", "group:" + group.name, 1, in);
  }
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
  std::vector<std::int32_t> connectivity, offsets;
  std::vector<std::uint8_t> types;
  const auto add = [&](const std::vector<std::int32_t>& nodes, std::uint8_t type) {
    connectivity.insert(connectivity.end(), nodes.begin(), nodes.end());
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
    types.push_back(type);
  };
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    add(nodes_of(mesh, t), second ? kVtkQuadraticTetra : kVtkTetra);
  for (const Facet& facet : mesh.facets)
    add(nodes_of(mesh, facet), second ? kVtkQuadraticTriangle : kVtkTriangle);
  arrays.add("Cells", "connectivity", 1, connectivity);
  arrays.add("Cells", "offsets", 1, offsets);
  arrays.add("Cells", "types", 1, types);
}

/// As a comment: VTK and meshio pass it over, and have no field data of text that both read.
void add_provenance(std::string& out, const Mesh& mesh) {
  const std::vector<std::string> lines = provenance(mesh);
  if (lines.empty()) return;
  out += "<!--\n";
  for (std::string line : lines) {
    // Two hyphens are not allowed in it.
    for (std::size_t at = line.find("--"); at != std::string::npos; at = line.find("--"))
      line.replace(at, 2, "- ");
    out.append(line).append("\n");
  }
  out += "-->\n";
}

}  // namespace

std::string to_vtu(const Mesh& mesh) {
  Arrays arrays;
  add_field_data(arrays, mesh);
  add_point_data(arrays, mesh);
  add_cell_data(arrays, mesh);
  add_geometry(arrays, mesh);
  arrays.place();

  std::string out = "<?xml version=\"1.0\"?>\n";
  add_provenance(out, mesh);
  out +=
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
      "  <UnstructuredGrid>\n"
      "    <FieldData>\n";
  arrays.write_tags(out, "FieldData");
  out += "    </FieldData>\n    <Piece NumberOfPoints=\"";
  append(out, mesh.nodes.size() + mesh.mid_nodes.size());
  out += "\" NumberOfCells=\"";
  append(out, mesh.tets.size() + mesh.facets.size());
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
