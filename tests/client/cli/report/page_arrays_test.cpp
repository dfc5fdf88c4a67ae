#include "client/cli/report/page_arrays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/cli/report/page_reader.h"
#include "tests/client/sample_mesh.h"

namespace remeshd::cli {
namespace {

using testing::Each;
using testing::Lt;
using testing::SizeIs;

struct SamplePage {
  client::Mesh mesh = client::sample_mesh(2);
  MeshFigures figures = figures_of_tets(mesh);
  std::vector<TetState> states = std::vector<TetState>(mesh.tets.size(), TetState::Moved);

  [[nodiscard]] std::map<std::string, PageArray> arrays(bool surfaces_only) const {
    std::map<std::string, PageArray> named;
    for (PageArray& array : page_arrays({.mesh = mesh,
                            .figures = figures,
                            .states = states,
                            .centre = {0.5, 1, -0.25},
                            .surfaces_only = surfaces_only}))
      named.emplace(array.name, std::move(array));
    return named;
  }
};

TEST(PageArrays, HoldAllOfAMesh) {
  const SamplePage page;
  const auto arrays = page.arrays(false);
  const auto tets = numbers<std::int32_t>(arrays.at("tets").bytes);
  ASSERT_THAT(tets, SizeIs(4 * page.mesh.tets.size()));
  for (std::size_t t = 0; t < page.mesh.tets.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(tets[4 * t + k], page.mesh.tets[t][k]);
  const auto nodes = numbers<float>(arrays.at("nodes").bytes);
  ASSERT_THAT(nodes, SizeIs(3 * page.mesh.nodes.size()));
  EXPECT_EQ(nodes[3], static_cast<float>(page.mesh.nodes[1][0] - 0.5));
  EXPECT_EQ(nodes[4], static_cast<float>(page.mesh.nodes[1][1] - 1));
  EXPECT_EQ(nodes[5], static_cast<float>(page.mesh.nodes[1][2] + 0.25));
  EXPECT_EQ(numbers<std::int32_t>(arrays.at("tet_cell").bytes), page.mesh.tet_cell);
  EXPECT_THAT(numbers<std::uint8_t>(arrays.at("tet_state").bytes), Each(2));
  EXPECT_EQ(arrays.at("sizes").count, page.mesh.nodes.size());
  EXPECT_EQ(arrays.at("facets").count, page.mesh.facets.size());
  EXPECT_EQ(numbers<std::int32_t>(arrays.at("facet_tet").bytes)[3], page.mesh.facets[3].tet);
  EXPECT_EQ(numbers<std::int32_t>(arrays.at("facet_group").bytes)[3], page.mesh.facets[3].group);
}

TEST(PageArrays, OfSurfacesHaveNoTetsAndNoNodeThatNoFacetHas) {
  SamplePage page;
  page.mesh.nodes.insert(page.mesh.nodes.begin(), {7, 7, 7});  // of no facet
  page.mesh.node_sizes.insert(page.mesh.node_sizes.begin(), 7);
  for (auto& facet : page.mesh.facets)
    for (std::int32_t& node : facet.nodes) ++node;
  const auto arrays = page.arrays(true);
  EXPECT_FALSE(arrays.contains("tets"));
  EXPECT_FALSE(arrays.contains("facet_tet"));
  const auto nodes = numbers<float>(arrays.at("nodes").bytes);
  const auto corners = numbers<std::int32_t>(arrays.at("facets").bytes);
  EXPECT_THAT(corners, Each(Lt(static_cast<std::int32_t>(nodes.size() / 3))));
  EXPECT_THAT(nodes, Each(Lt(6)));
  const auto corner = static_cast<std::size_t>(corners[0]);
  const auto& node = page.mesh.nodes[static_cast<std::size_t>(page.mesh.facets[0].nodes[0])];
  EXPECT_EQ(nodes[3 * corner + 1], static_cast<float>(node[1] - 1));
  EXPECT_EQ(arrays.at("sizes").count, nodes.size() / 3);
}

TEST(PageArrays, UnpackToTheSameBytes) {
  std::string bytes;
  for (int k = 0; k < 100'000; ++k) bytes += static_cast<char>((k * k) >> 3);
  for (const std::size_t length : {0U, 1U, 2U, 3U, 100'000U})
    EXPECT_EQ(unpacked(packed(bytes.substr(0, length))), bytes.substr(0, length)) << length;
}

TEST(TetFigures, HaveTheWorstTetsFirstAndCountEachTetOnce) {
  client::Mesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {.3, .3, 1e-6}};
  mesh.tets = {{0, 1, 2, 3}, {1, 4, 2, 3}, {0, 1, 2, 5}};
  const MeshFigures figures = figures_of_tets(mesh);
  ASSERT_THAT(figures.worst, SizeIs(3));
  EXPECT_EQ(figures.worst[0].tet, 2);
  EXPECT_NEAR(figures.worst[0].least_angle, 0, 1e-3);
  EXPECT_NEAR(figures.worst[0].largest_angle, 180, 1e-3);
  EXPECT_EQ(figures.worst[2].tet, 1);
  EXPECT_NEAR(figures.worst[2].volume_length, 1, 1e-12) << "a regular tet";
  EXPECT_EQ(figures.qualities.front(), 1U);
  EXPECT_EQ(figures.qualities.back(), 1U);
  std::uint32_t angles = 0;
  for (const std::uint32_t count : figures.angles) angles += count;
  EXPECT_EQ(angles, 18U);
}

}  // namespace
}  // namespace remeshd::cli
