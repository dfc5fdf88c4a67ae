#include "client/formats/read_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "remeshd/mesh_file.h"
#include "tests/client/formats/raw_arrays.h"
#include "tests/client/sample_mesh.h"
#include "tests/support/temporary_folder.h"

namespace remeshd::client {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
using Tets = std::vector<std::array<std::int32_t, 4>>;

TEST(ReadMesh, ReadsWhatMeshioAndVtkWriteInEachOfTheirWays) {
  const Mesh mesh = sample_mesh(4);
  const TemporaryFolder folder;
  write_raw_arrays(folder.path(), mesh);
  ASSERT_TRUE(run_script("write_by_others.py", {folder.path()}));
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    if (!is_mesh_file_name(entry.path())) continue;
    const std::string name = entry.path().filename().string();
    SCOPED_TRACE(name);
    ++files;
    // VTK writes the whole mesh once for each piece asked for; the second one's nodes count on.
    const std::size_t pieces = name.find("pieces") == std::string::npos ? 1 : 2;
    const double rounded = name == "meshio-ascii.vtu" ? 1e-11 : 0;  // it writes 12 digits
    const FileMesh back = read_mesh(entry.path());
    ASSERT_EQ(back.nodes.size(), pieces * mesh.nodes.size());
    for (std::size_t n = 0; n < back.nodes.size(); ++n)
      for (std::size_t axis = 0; axis < 3; ++axis)
        ASSERT_NEAR(back.nodes[n][axis], mesh.nodes[n % mesh.nodes.size()][axis],
                    rounded * std::fabs(back.nodes[n][axis]))
            << n;
    Tets wanted = mesh.tets;
    if (pieces == 2)
      for (auto tet : mesh.tets) {
        for (std::int32_t& node : tet) node += static_cast<std::int32_t>(mesh.nodes.size());
        wanted.push_back(tet);
      }
    ASSERT_EQ(back.tets, wanted);
  }
  EXPECT_EQ(files, 25);
}

TEST(Vtu, CountsTheNodesOfItsPiecesOn) {
  const std::string piece = R"(<Piece NumberOfPoints="4" NumberOfCells="1"><Points>)"
                            R"(<DataArray type="Float64" NumberOfComponents="3" format="ascii">)";
  const std::string cells =
      R"(</DataArray></Points><Cells><DataArray type="Int64" Name="connectivity" format="ascii">)"
      R"(0 1 2 3</DataArray><DataArray type="Int64" Name="offsets" format="ascii">4</DataArray>)"
      R"(<DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells></Piece>)";
  const FileMesh mesh = parse_vtu(
      R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid>)" + piece + "0 0 0 1 0 0 0 1 0 0 0 1" +
      cells + piece + "5 0 0 7 0 0 5 2 0 5 0 2" + cells + "</UnstructuredGrid></VTKFile>");
  ASSERT_EQ(mesh.nodes.size(), 8U);
  EXPECT_EQ(mesh.nodes[4], (std::array{5.0, 0.0, 0.0}));
  EXPECT_EQ(mesh.tets, (Tets{{0, 1, 2, 3}, {4, 5, 6, 7}}));
}

TEST(Vtu, WhoseBase64EndsWithinItsSizesIsRefused) {
  for (const char* compressor : {"", R"(compressor="vtkZLibDataCompressor")"})
    EXPECT_THROW(
        parse_vtu(std::string(R"(<VTKFile type="UnstructuredGrid" )") + compressor +
                  R"(><UnstructuredGrid><Piece><Points><DataArray type="Float64" format="binary">)"
                  "AA==AA==AA==AA==</DataArray></Points></Piece></UnstructuredGrid></VTKFile>"),
        FileError);
}

TEST(Msh, ThatEndsBehindABinaryHeaderIsRefused) {
  EXPECT_THROW(parse_msh("$MeshFormat\n4.1 1 8"), FileError);
  EXPECT_THROW(parse_msh("$MeshFormat\n4.1 1 8\n"), FileError);
}

TEST(Msh, WithoutItsFormatIsRefused) {
  EXPECT_THROW(parse_msh("$Nodes\n0 0 0 0\n$EndNodes\n"), FileError);
  EXPECT_THROW(parse_msh("$Elements\n0 0 0 0\n$EndElements\n"), FileError);
  const std::string no_nodes(4 * sizeof(std::uint64_t), '\0');
  EXPECT_THROW(parse_msh("$Nodes\n" + no_nodes + "\n$EndNodes\n"), FileError);
  EXPECT_TRUE(parse_msh("$Comments\nnone\n$EndComments\n"
                        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n0 0 0 0\n$EndNodes\n")
                  .nodes.empty());
}

// Gmsh 4.8 wrote it, with -parametric: the places of nodes on curves and surfaces go on with one or
// two parameters, which are no coordinates.
TEST(Msh, ParametersOfNodesArePassedOver) {
  const FileMesh mesh = read_mesh(beside_this("cylinder-by-gmsh.msh"));
  ASSERT_EQ(mesh.nodes.size(), 14U);
  for (const auto& [x, y, z] : mesh.nodes) {
    const double radius = std::hypot(x, y);
    EXPECT_TRUE(radius < 1e-12 || std::fabs(radius - 1) < 1e-12) << radius;
    EXPECT_TRUE(z == 0 || z == 0.5 || z == 1) << z;
  }
  EXPECT_EQ(mesh.nodes[1], (std::array{1.0, -2.449293598294706e-16, 0.0}));   // of a point
  EXPECT_EQ(mesh.nodes[6], (std::array{-1.0, -4.318427418585891e-15, 0.0}));  // of a curve
  EXPECT_EQ(mesh.nodes[10], (std::array{0.7071067811865471, 0.7071067811865479, 0.5}));  // a face
  ASSERT_EQ(mesh.tets.size(), 24U);
  EXPECT_EQ(mesh.tets.front(), (std::array{13, 0, 12, 11}));
  EXPECT_EQ(mesh.tets.back(), (std::array{4, 7, 9, 13}));
}

/// Twelve nodes, then what is given.
std::string inp(const std::string& rest) {
  std::string out = "*NODE\n";
  for (int n = 1; n <= 12; ++n)
    out += std::to_string(n) + ", " + std::to_string(n * n) + ", " + std::to_string(n % 3) + ", " +
           std::to_string(n % 2) + "\n";
  return out + rest;
}

TEST(Inp, WhoseLastLineHasNoEndIsReadWhereItsLastNumberCannotGoOn) {
  const std::string begin = "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n2, 5, 6, 7, ";
  EXPECT_EQ(parse_inp(inp(begin + "8")).tets, (Tets{{0, 1, 2, 3}, {4, 5, 6, 7}}));
  EXPECT_EQ(parse_inp(inp(begin + "12")).tets.back(), (std::array{4, 5, 6, 11}));
  // Of 10, 11 or 12, perhaps.
  EXPECT_THAT([&] { parse_inp(inp(begin + "1")); },
              ThrowsMessage<FileError>(HasSubstr("its last line may be cut")));
  for (const char* end : {"\n", "\r\n", "\r", " ", ",", ", "})
    EXPECT_EQ(parse_inp(inp(begin + "1" + end)).tets.back(), (std::array{4, 5, 6, 0})) << end;
}

TEST(Inp, WhoseLastLineIsAnotherBlocksNeedsNoEnd) {
  const std::string tets = "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 1\n";
  for (const char* last : {"*END STEP", "** done", "*NSET, NSET=all\n1, 1", "*NSET, NSET=all\n1,"})
    EXPECT_EQ(parse_inp(inp(tets + last)).tets.size(), 1U) << last;
}

TEST(Inp, WhoseLastNodeHasNoEndIsRefused) {
  const std::string tets = "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n*NODE\n";
  EXPECT_THROW(parse_inp(inp(tets + "13, 1, 2, 0.2")), FileError);
  EXPECT_EQ(parse_inp(inp(tets + "13, 1, 2, 0.2\n")).nodes.size(), 13U);
}

TEST(Inp, WithFewerNodesOrTetsThanItsHeadTellsOfIsRefused) {
  const std::string whole = inp("*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n2, 5, 6, 7, 8\n");
  const std::string head = "** as many nodes and tets were written: ";
  EXPECT_EQ(parse_inp(head + "12, 2\n" + whole).tets.size(), 2U);
  EXPECT_EQ(parse_inp(head + "11, 1\n" + whole).tets.size(), 2U);  // more came by hand
  for (const char* more : {"12, 3\n", "13, 2\n"})
    EXPECT_THAT([&] { parse_inp(std::string(head).append(more).append(whole)); },
                ThrowsMessage<FileError>(HasSubstr("it is cut")));
}

}  // namespace
}  // namespace remeshd::client
