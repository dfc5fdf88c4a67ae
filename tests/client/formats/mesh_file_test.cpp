#include "remeshd/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>

#include "client/formats/read_mesh.h"
#include "client/formats/scanner.h"
#include "tests/client/formats/raw_arrays.h"
#include "tests/client/sample_mesh.h"
#include "tests/support/temporary_folder.h"

namespace remeshd::client {
namespace {

/// No file of this process grows beyond `bytes` while this lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*signal_)(int);
};

std::string slurp(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class MeshFile : public testing::TestWithParam<const char*> {
 protected:
  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / (std::string("mesh") + GetParam());

  static FileMesh parse(std::string_view bytes) {
    const std::string format = GetParam();
    if (format == ".vtu") return parse_vtu(bytes);
    return format == ".msh" ? parse_msh(bytes) : parse_inp(bytes);
  }
};

TEST_P(MeshFile, IsReadBackToTheBitByIndependentLibraries) {
  const Mesh mesh = sample_mesh(3);
  write_mesh(file_, mesh);
  write_raw_arrays(folder_.path(), mesh);
  EXPECT_TRUE(run_script("read_back.py", {file_, folder_.path()}));
}

TEST_P(MeshFile, OfSecondOrderIsReadBackToTheBitByIndependentLibraries) {
  const Mesh mesh = with_mid_nodes(sample_mesh(2));
  write_mesh(file_, mesh);
  write_raw_arrays(folder_.path(), mesh);
  EXPECT_TRUE(run_script("read_back.py", {file_, folder_.path()}));
}

TEST_P(MeshFile, WithGroupsIsReadBackToTheBitByIndependentLibraries) {
  for (const Mesh& mesh :
       {with_groups(sample_mesh(2)), with_mid_nodes(with_groups(sample_mesh(1)))}) {
    write_mesh(file_, mesh);
    write_raw_arrays(folder_.path(), mesh);
    EXPECT_TRUE(run_script("read_back.py", {file_, folder_.path()}));
  }
}

TEST_P(MeshFile, TellsWhereItComesFrom) {
  write_mesh(file_, with_groups(sample_mesh(1)));
  const std::string text = slurp(file_);
  for (const char* line : {"revision 0123abcd\n", "parent 4567ef\n", "unit mm\n",
                           "options {\"nodes\": 27}\n", "remeshd algorithm 20\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
  EXPECT_NE(text.find("model brick "), std::string::npos);
}

TEST_P(MeshFile, WithControlCharactersInNameAndUnitIsReadBackToTheBit) {
  Mesh mesh = sample_mesh(1);
  mesh.model_name = "two\n*STEP\r\x7f.";
  mesh.unit = "m\x01m";
  write_mesh(file_, mesh);
  const std::string text = slurp(file_);
  for (const char* line : {"model two *STEP  .\n", "unit m m\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
  write_raw_arrays(folder_.path(), mesh);
  EXPECT_TRUE(run_script("read_back.py", {file_, folder_.path()}));
}

TEST_P(MeshFile, OfSecondOrderIsReadBackByOurOwnReader) {
  const Mesh mesh = with_mid_nodes(sample_mesh(2));
  write_mesh(file_, mesh);
  const FileMesh back = read_mesh(file_);
  EXPECT_EQ(back.nodes.size(), mesh.nodes.size() + mesh.mid_nodes.size());
  EXPECT_EQ(back.tets, mesh.tets);
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

TEST_P(MeshFile, CutAnywhereIsRefusedOrHasAllNodesAndTets) {
  const Mesh mesh = sample_mesh(1);
  write_mesh(file_, mesh);
  const std::string whole = slurp(file_);
  int refused = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string_view cut = std::string_view(whole).substr(0, size);
    try {
      const FileMesh back = parse(cut);
      if (back.tets.empty()) throw FileError("read_mesh() refuses it");
      ASSERT_EQ(back.nodes, mesh.nodes) << size;
      ASSERT_EQ(back.tets, mesh.tets) << size;
    } catch (const FileError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 500);
}

TEST_P(MeshFile, CutInTheMiddleIsRefusedByItsName) {
  write_mesh(file_, sample_mesh(1));
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) / 2);
  EXPECT_THAT([&] { read_mesh(file_); },
              testing::ThrowsMessage<FormatError>(testing::StartsWith(file_.string() + ": ")));
}

TEST_P(MeshFile, ThatCannotBeWrittenWholeIsLeftAsItWasAndNothingBesideIt) {
  write_mesh(file_, sample_mesh(1));
  const std::string before = slurp(file_);
  {
    const FileSizeLimit limit(2000);
    EXPECT_THROW(write_mesh(file_, sample_mesh(3)), FileError);
    EXPECT_THROW(write_mesh(folder_ / (std::string("another") + GetParam()), sample_mesh(3)),
                 FileError);
  }
  EXPECT_EQ(slurp(file_), before);
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
    EXPECT_EQ(entry.path(), file_);
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshFile, testing::Values(".vtu", ".msh", ".inp"),
                         [](const auto& name) { return std::string(name.param + 1); });

TEST(MeshFileName, DecidesTheFormatAndAnUnknownOneIsRefused) {
  EXPECT_TRUE(is_mesh_file_name("a/b.vtu"));
  EXPECT_FALSE(is_mesh_file_name("a/b.stl"));
  EXPECT_THROW(write_mesh("/tmp/mesh.stl", sample_mesh(1)), FileError);
  EXPECT_THROW(write_mesh("/nowhere/at/all.vtu", sample_mesh(1)), FileError);
}

TEST(Msh, NoTwoPhysicalGroupsHaveOneNumber) {
  const std::string text = to_msh(sample_mesh(1));
  std::istringstream in(text.substr(text.find("$PhysicalNames") + 15));
  std::size_t count = 0;
  in >> count;
  std::vector<int> dimensions, tags;
  std::string name;
  for (int dimension = 0, tag = 0; tags.size() < count && in >> dimension >> tag >> name;) {
    dimensions.push_back(dimension);
    tags.push_back(tag);
  }
  ASSERT_EQ(tags.size(), count);
  EXPECT_THAT(dimensions, testing::Contains(3));
  for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(tags[k], static_cast<int>(k) + 1);
}

TEST(Msh, GivesAnEntityEachPhysicalGroupOnce) {
  // `base` is alone on a cell and shares the other with `Slot1`; `base.top` likewise.
  using Tags = std::vector<std::vector<std::int32_t>>;
  const std::string bytes = to_msh(sample_mesh(1));
  Scanner scanner(bytes);
  ASSERT_TRUE(scanner.skip_past_line("$Entities"));
  scanner.skip(2 * sizeof(std::uint64_t));  // no points, no curves
  std::array<Tags, 2> tags;                 // of surfaces, volumes
  for (Tags& of : tags) of.resize(scanner.raw<std::uint64_t>());
  for (Tags& of : tags)
    for (auto& entity : of) {
      scanner.skip(sizeof(std::int32_t) + 6 * sizeof(double));  // its own tag and box
      entity.resize(scanner.raw<std::uint64_t>());
      for (std::int32_t& tag : entity) tag = scanner.raw<std::int32_t>();
      scanner.skip(sizeof(std::uint64_t));  // bounded by none
    }
  // Each its own first; Slot1.x_max is 7, base.x_max 8, Slot1.top 9, and of the cells, which
  // count on, base 10, both 11 and Slot1 12.
  EXPECT_EQ(tags[0], (Tags{{1}, {2, 7, 8}, {3}, {4}, {5}, {6, 5, 9}}));
  EXPECT_EQ(tags[1], (Tags{{10}, {11, 10, 12}}));
}

TEST(Msh, BoxesOfEntitiesHoldAllTheirNodes) {
  const Mesh mesh = sample_mesh(2);
  const std::string bytes = to_msh(mesh);
  Scanner scanner(bytes);
  ASSERT_TRUE(scanner.skip_past_line("$Entities"));
  scanner.skip(2 * sizeof(std::uint64_t));  // no points, no curves
  ASSERT_EQ(scanner.raw<std::uint64_t>(), mesh.facet_groups.size());
  scanner.skip(sizeof(std::uint64_t));  // volumes
  for (std::size_t group = 0; group < mesh.facet_groups.size(); ++group) {
    std::array<double, 6> expected{HUGE_VAL, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const Facet& facet : mesh.facets)
      if (facet.group == static_cast<std::int32_t>(group))
        for (const std::int32_t n : facet.nodes)
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = mesh.nodes[static_cast<std::size_t>(n)][axis];
            expected[axis] = std::fmin(expected[axis], x);
            expected[3 + axis] = std::fmax(expected[3 + axis], x);
          }
    scanner.skip(sizeof(std::int32_t));  // its own tag
    std::array<double, 6> box{};
    for (double& bound : box) bound = scanner.raw<double>();
    EXPECT_EQ(box, expected) << mesh.facet_groups[group].front();
    scanner.skip(scanner.raw<std::uint64_t>() * sizeof(std::int32_t) + sizeof(std::uint64_t));
  }
}

TEST(Inp, HasNoMoreThanSixteenNumbersALine) {
  std::istringstream text(to_inp(sample_mesh(3)));
  std::ptrdiff_t most = 0;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with('*')) continue;
    if (line.ends_with(',')) line.pop_back();  // the set goes on
    most = std::max(most, 1 + std::ranges::count(line, ','));
  }
  EXPECT_EQ(most, 16);
}

TEST(Inp, WritesCoordinatesThatCalculixCanCutAtTwentyCharacters) {
  Mesh mesh = sample_mesh(1);
  mesh.nodes[0] = {-1.2345678901234567e-15, 123456.78901234567, -0.1 - 0.2};
  mesh.nodes[1] = {0, -0.0, 2};
  std::istringstream text(to_inp(mesh));
  std::string line;
  while (std::getline(text, line) && line != "*NODE") continue;
  std::getline(text, line);
  EXPECT_EQ(line,
            "1, -0.0000000000000012345678901234568, 123456.78901234567, -0.30000000000000004");
  std::getline(text, line);
  EXPECT_EQ(line, "2, 0.0, -0.0, 2.0");
}

TEST(Inp, WritesAnExponentWhereACoordinateWouldHaveManyZeros) {
  Mesh mesh = sample_mesh(1);
  mesh.nodes[0] = {1e-70, 1e17, 1};
  EXPECT_NE(to_inp(mesh).find("\n1, 1e-70, 1e+17, 1.0\n"), std::string::npos);
}

TEST(Inp, TellsLabelsApartThatDifferByCaseOnly) {
  Mesh mesh = sample_mesh(1);
  mesh.cell_owners = {{"Base"}, {"base"}};
  const std::string text = to_inp(mesh);
  EXPECT_NE(text.find("** feature Base\n*ELSET, ELSET=Base\n"), std::string::npos);
  EXPECT_NE(text.find("** feature base\n*ELSET, ELSET=base_2\n"), std::string::npos);
}

TEST(Inp, CallsTheSetsOfEverythingOtherwiseWhereAGroupHasTheirName) {
  Mesh mesh = with_groups(sample_mesh(1));
  mesh.group_names = {"remesh_all", "part", "nothing"};  // facets alone, both, neither
  const std::string of_facets = to_inp(mesh);
  for (const char* line :
       {"** group remesh_all\n*NSET, NSET=remesh_all\n", "*SURFACE, NAME=remesh_all, ",
        "*NSET, NSET=remesh_all_2, GENERATE\n", "*ELSET, ELSET=remesh_all_2, GENERATE\n"})
    EXPECT_THAT(of_facets, testing::HasSubstr(line));
  mesh.group_names = {"load", "Remesh_All", "remesh_all_2"};
  const std::string of_both = to_inp(mesh);
  for (const char* line :
       {"** group Remesh_All\n*NSET, NSET=Remesh_All\n",
        "** group Remesh_All\n*ELSET, ELSET=Remesh_All\n", "*NSET, NSET=remesh_all_3, GENERATE\n",
        "*ELSET, ELSET=remesh_all_3, GENERATE\n"})
    EXPECT_THAT(of_both, testing::HasSubstr(line));
}

}  // namespace
}  // namespace remeshd::client
