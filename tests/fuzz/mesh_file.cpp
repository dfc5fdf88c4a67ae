// Mesh files that the command line measures. The first byte chooses the format.
#include "remeshd/mesh_file.h"
#include "client/formats/read_mesh.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/targets.h"

namespace remeshd::fuzz {
namespace {

constexpr client::FileMesh (*kFormats[])(std::string_view) = {client::parse_vtu, client::parse_msh,
                                                              client::parse_inp};

void check(const client::FileMesh& mesh) {
  for (const auto& tet : mesh.tets)
    for (const std::int32_t node : tet)
      expect(node >= 0 && static_cast<std::size_t>(node) < mesh.nodes.size(),
             "a tet of a node that is not there");
}

const char* const kAsciiVtu =
    R"(<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>)"
    R"(<Piece NumberOfPoints="4" NumberOfCells="1"><Points><DataArray type="Float64" )"
    R"(NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>)"
    R"(<DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>)"
    R"(<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray>)"
    R"(<DataArray type="UInt8" Name="types" format="ascii">10</DataArray>)"
    R"(</Cells></Piece></UnstructuredGrid></VTKFile>)";

const char* const kAsciiMsh =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n"
    "0 1 0\n0 0 1\n$EndNodes\n$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";

const char* const kInp =
    "** a mesh\n*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n"
    "*ELEMENT, TYPE=C3D4, ELSET=all\n1, 1, 2, 3, 4\n*NSET, NSET=x\n1\n";

client::Mesh one_tet() {
  return {.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          .tets = {{0, 1, 2, 3}},
          .node_ids = {1, 2, 3, 4},
          .tet_ids = {1},
          .facets = {{{0, 2, 1}, 0, 0}},
          .facet_groups = {{"plate.top"}},
          .tet_cell = {0},
          .cell_owners = {{"plate"}},
          .node_origin = std::vector(4, client::NodeOrigin::New),
          .original_node = {-1, -1, -1, -1},
          .node_transform = {-1, -1, -1, -1},
          .original_tet = {-1}};
}

}  // namespace
}  // namespace remeshd::fuzz

int fuzz_mesh_file(const std::uint8_t* data, std::size_t size) {
  using namespace remeshd;
  fuzz::Input input(data, size);
  const auto parse = fuzz::kFormats[input.byte() % std::size(fuzz::kFormats)];
  try {
    fuzz::check(parse(input.rest()));
  } catch (const client::FileError& error) {
    fuzz::expect(*error.what() != '\0', "an error without words");
  }
  return 0;
}

remeshd::fuzz::Seeds remeshd::fuzz::mesh_file_seeds() {
  using namespace remeshd::client;
  const Mesh mesh = one_tet();
  return {'\0' + std::string(kAsciiVtu), '\0' + to_vtu(mesh),      '\1' + std::string(kAsciiMsh),
          '\1' + to_msh(mesh),           '\2' + std::string(kInp), '\2' + to_inp(mesh)};
}
