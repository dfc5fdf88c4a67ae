#include "client/cli/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

TEST_F(Cli, QualityMeasuresARegularTetExactly) {
  std::ofstream(folder_ / "t.inp")
      << "*NODE\n1, 1, 1, 1\n2, 1, -1, -1\n3, -1, -1, 1\n4, -1, 1, -1\n"
         "*ELEMENT, TYPE=C3D4, ELSET=All\n1, 1, 2, 4, 3\n";
  ASSERT_EQ(run({"quality", file("t.inp"), "--exact-volume", "2"}), kFine) << err_.str();
  const auto json = nlohmann::json::parse(out_.str());
  EXPECT_EQ(json["nodes"], 4);
  EXPECT_EQ(json["bfaces"], 4);
  EXPECT_EQ(json["neg"], 0);
  EXPECT_NEAR(json["vl_min"], 1, 1e-15);
  EXPECT_NEAR(json["dih_min"], 70.528779365509, 1e-10);
  EXPECT_NEAR(json["dih_max"], 70.528779365509, 1e-10);
  EXPECT_EQ(json["f20"], 0);
  EXPECT_NEAR(json["volume"], 8.0 / 3, 1e-15);
  EXPECT_NEAR(json["vol_err"], 1.0 / 3, 1e-15);
  EXPECT_NEAR(json["edge_mean"], std::sqrt(8), 1e-15);
}

/// A tet on an equilateral triangle, whose other three facets rise from it at `degrees`.
client::FileMesh cap(double degrees) {
  const double half = std::sqrt(0.75);
  return {.nodes = {{1, 0, 0},
                    {-0.5, half, 0},
                    {-0.5, -half, 0},
                    {0, 0, 0.5 * std::tan(degrees * std::numbers::pi / 180)}},
          .tets = {{0, 1, 2, 3}}};
}

TEST(Measure, LeastQualityIsThatOfTheWorstTet) {
  client::FileMesh two = cap(50);
  for (const auto& node : cap(20).nodes) two.nodes.push_back(node);
  two.tets.push_back({4, 5, 6, 7});
  EXPECT_EQ(measure(two, {}).vl_min, measure(cap(20), {}).vl_min);
  EXPECT_LT(measure(cap(20), {}).vl_min, measure(cap(50), {}).vl_min);
}

TEST(Measure, AFlatTetIsWrongWhicheverWayTheOthersTurn) {
  client::FileMesh mesh = cap(50);
  for (const auto& node : cap(0).nodes) mesh.nodes.push_back(node);
  mesh.tets.push_back({4, 5, 6, 7});
  EXPECT_EQ(measure(mesh, {}).neg, 1U);
  std::swap(mesh.tets[0][2], mesh.tets[0][3]);
  EXPECT_EQ(measure(mesh, {}).neg, 1U);
}

TEST(Measure, TellsTheShareOfSmallAnglesAndOfTetsThatHaveOne) {
  const Measures below_20 = measure(cap(15), {});
  EXPECT_NEAR(below_20.dih_min, 15, 1e-9);
  EXPECT_EQ(below_20.f20, 0.5);
  EXPECT_EQ(below_20.f_tet_20, 1);
  EXPECT_EQ(below_20.f10, 0);
  EXPECT_EQ(below_20.f_tet_10, 0);
  const Measures below_10 = measure(cap(5), {});
  EXPECT_EQ(below_10.f10, 0.5);
  EXPECT_EQ(below_10.f_tet_10, 1);
  const Measures of_none = measure(cap(30), {});
  EXPECT_EQ(of_none.f20, 0);
  EXPECT_EQ(of_none.f_tet_20, 0);
}

}  // namespace
}  // namespace remeshd::cli
