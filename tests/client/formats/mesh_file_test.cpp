#include "remeshd/mesh_file.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "client/formats/read_mesh.h"
#include "tests/client/sample_mesh.h"
#include "tests/client/temporary_folder.h"

namespace remeshd::client {
namespace {

std::string slurp(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

template <class T>
void dump(const std::filesystem::path& path, const std::vector<T>& values) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(T)));
}

std::string json(const std::vector<std::vector<std::string>>& lists) {
  std::string out;
  for (const auto& list : lists) {
    std::string inner;
    for (const auto& name : list) inner += (inner.empty() ? "\"" : ", \"") + name + "\"";
    out += (out.empty() ? "[" : ", [") + inner + "]";
  }
  return "[" + out + "]";
}

/// The mesh as raw arrays for read_back.py.
void dump(const std::filesystem::path& folder, const Mesh& mesh) {
  dump(folder / "points", mesh.nodes);
  dump(folder / "tets", mesh.tets);
  dump(folder / "origin", mesh.node_origin);
  dump(folder / "original_node", mesh.original_node);
  dump(folder / "node_id", mesh.node_ids);
  dump(folder / "original_tet", mesh.original_tet);
  dump(folder / "tet_id", mesh.tet_ids);
  dump(folder / "cell", mesh.tet_cell);
  dump(folder / "facets", mesh.facets);
  std::ofstream(folder / "names.json") << "{\"facet_groups\": " << json(mesh.facet_groups)
                                       << ", \"cell_owners\": " << json(mesh.cell_owners) << "}";
}

class MeshFile : public testing::TestWithParam<const char*> {
 protected:
  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / (std::string("mesh") + GetParam());
};

TEST_P(MeshFile, IsReadBackToTheBitByIndependentLibraries) {
  const Mesh mesh = sample_mesh(3);
  write_mesh(file_, mesh);
  dump(folder_.path(), mesh);
  const std::filesystem::path script =
      std::filesystem::path(REMESHD_CASES_DIR).parent_path() / "client/formats/read_back.py";
  const std::string command =
      "/usr/bin/python3 " + script.string() + " " + file_.string() + " " + folder_.path().string();
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

TEST_P(MeshFile, IsReadBackToTheBitByOurOwnReader) {
  const Mesh mesh = sample_mesh(2);
  write_mesh(file_, mesh);
  const FileMesh back = read_mesh(file_);
  ASSERT_EQ(back.nodes.size(), mesh.nodes.size());
  for (std::size_t k = 0; k < mesh.nodes.size(); ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(back.nodes[k][axis]),
                std::bit_cast<std::uint64_t>(mesh.nodes[k][axis]));
  }
  EXPECT_EQ(back.tets, mesh.tets);
}

TEST_P(MeshFile, HasTheSameBytesForTheSameMesh) {
  write_mesh(file_, sample_mesh(2));
  const std::string first = slurp(file_);
  write_mesh(file_, sample_mesh(2));
  EXPECT_EQ(slurp(file_), first);
}

TEST_P(MeshFile, CutAnywhereIsRefusedOrStillWhole) {
  const Mesh mesh = sample_mesh(1);
  write_mesh(file_, mesh);
  const std::string whole = slurp(file_);
  for (std::size_t size = 0; size < whole.size(); size += 41) {
    std::ofstream(file_, std::ios::binary) << whole.substr(0, size);
    try {
      EXPECT_LE(read_mesh(file_).tets.size(), mesh.tets.size());
    } catch (const FileError& e) {
      EXPECT_NE(std::string(e.what()).find(file_.string()), std::string::npos);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshFile, testing::Values(".vtu", ".msh", ".inp"),
                         [](const auto& name) { return std::string(name.param + 1); });

TEST(MeshFileName, DecidesTheFormatAndAnUnknownOneIsRefused) {
  EXPECT_TRUE(is_mesh_file_name("a/b.vtu"));
  EXPECT_FALSE(is_mesh_file_name("a/b.stl"));
  EXPECT_THROW(write_mesh("/tmp/mesh.stl", sample_mesh(1)), FileError);
  EXPECT_THROW(write_mesh("/nowhere/at/all.vtu", sample_mesh(1)), FileError);
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

TEST(Inp, WritesCoordinatesThatCalculixCanCutAtTwentyCharacters) {
  Mesh mesh = sample_mesh(1);
  mesh.nodes[0] = {-1.2345678901234567e-15, 123456.78901234567, -0.1 - 0.2};
  std::istringstream text(to_inp(mesh));
  std::string line;
  while (std::getline(text, line) && line != "*NODE") continue;
  std::getline(text, line);
  EXPECT_EQ(line,
            "1, -0.0000000000000012345678901234568, 123456.78901234567, -0.30000000000000004");
}

TEST(Inp, TellsLabelsApartThatDifferByCaseOnly) {
  Mesh mesh = sample_mesh(1);
  mesh.cell_owners = {{"Base"}, {"base"}};
  const std::string text = to_inp(mesh);
  EXPECT_NE(text.find("** feature Base\n*ELSET, ELSET=Base\n"), std::string::npos);
  EXPECT_NE(text.find("** feature base\n*ELSET, ELSET=base_2\n"), std::string::npos);
}

}  // namespace
}  // namespace remeshd::client
