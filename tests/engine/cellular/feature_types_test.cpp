// Every type of client/docs/model.md as a model of one feature: what its boundary is made of.
#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <set>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

using std::numbers::pi;
using test::arc;
using test::feature;
using test::one_feature;
using test::point;

struct Expected {
  const char* name;
  FeatureSource source;
  double volume, area;
  std::size_t vertices, edges, faces;
  std::set<std::string> names;
};

class FeatureTypes : public ::testing::TestWithParam<Expected> {};

TEST_P(FeatureTypes, BoundaryIsExactAndHasNoSeams) {
  const Expected& expected = GetParam();
  FeatureSource source = expected.source;
  source.placement.origin = {12.0, -7.0, 3.0};
  source.placement.z_axis = {1.0, 2.0, 2.0};
  const CellularModel model = build_cells(evaluate(one_feature(source)), kRun);
  const BoundaryModel& b = model.boundary;
  EXPECT_NEAR(model.volume, expected.volume, 1e-9 * expected.volume);
  EXPECT_NEAR(model.area, expected.area, 1e-9 * expected.area);
  EXPECT_EQ(b.vertices.size(), expected.vertices);
  EXPECT_EQ(b.edges.size(), expected.edges);
  EXPECT_EQ(b.faces.size(), expected.faces);
  std::set<std::string> names;
  for (const BoundaryFace& face : b.faces)
    for (const FaceName& name : face.names) names.insert(name.face);
  EXPECT_EQ(names, expected.names);
  ASSERT_EQ(model.complex().cells.size(), 1u);
  EXPECT_EQ(model.complex().edges.size(), expected.edges)
      << "elements of the cellular model are no seams";
  EXPECT_EQ(model.complex().vertices.size(), expected.vertices);
}

TEST_P(FeatureTypes, FacetsAreWatertightAndLookOutwards) {
  FeatureSource source = GetParam().source;
  source.placement.origin = {12.0, -7.0, 3.0};
  source.placement.z_axis = {1.0, 2.0, 2.0};
  const CellularModel model = build_cells(evaluate(one_feature(source)), kRun);
  std::map<std::array<double, 6>, int> half_edges;
  double volume = 0;
  for (const BoundaryFace& face : model.boundary.faces)
    for (const auto& t : face.triangles) {
      const std::array<Vec3, 3> p{face.points[t[0]], face.points[t[1]], face.points[t[2]]};
      volume += dot(p[0], cross(p[1], p[2])) / 6;
      for (int i = 0; i < 3; ++i) {
        const Vec3 &a = p[i], &c = p[(i + 1) % 3];
        ++half_edges[{a.x, a.y, a.z, c.x, c.y, c.z}];
      }
      const Vec3 centre = (p[0] + p[1] + p[2]) / 3;
      const Vec3 out = (face.reversed ? -1 : 1) * normal(face.surface, centre);
      EXPECT_GT(dot(out, normalised(cross(p[1] - p[0], p[2] - p[0]))), 0.9);
    }
  for (const auto& [h, n] : half_edges) {
    EXPECT_EQ(n, 1);
    EXPECT_EQ(half_edges.count({h[3], h[4], h[5], h[0], h[1], h[2]}), 1u);
  }
  EXPECT_NEAR(volume, GetParam().volume, 0.02 * GetParam().volume);
}

TEST_P(FeatureTypes, EveryPointOfAFaceOrEdgeLiesOnItsSurfaces) {
  const CellularModel model = build_cells(evaluate(one_feature(GetParam().source)), kRun);
  const BoundaryModel& b = model.boundary;
  for (const BoundaryFace& face : b.faces)
    for (const Vec3& p : face.points) EXPECT_NEAR(signed_distance(face.surface, p), 0, 1e-8);
  for (const BoundaryEdge& edge : b.edges) {
    EXPECT_EQ(edge.faces.size(), 2u);
    for (const int f : edge.faces)
      for (const Vec3& p : edge.points)
        EXPECT_NEAR(signed_distance(b.faces[f].surface, p), 0, 1e-10);
    for (std::size_t i = 0; i + 2 < edge.points.size(); ++i) {
      const Vec3 d = normalised(edge.points[i + 1] - edge.points[i]);
      const Vec3 e = normalised(edge.points[i + 2] - edge.points[i + 1]);
      EXPECT_LT(std::acos(std::min(1.0, dot(d, e))), 6.0 * pi / 180);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Table, FeatureTypes,
    ::testing::Values(
        Expected{"block",
                 feature("a", "block", {{"dx", 4.0}, {"dy", 5.0}, {"dz", 6.0}}),
                 120,
                 148,
                 8,
                 12,
                 6,
                 {"x_min", "x_max", "y_min", "y_max", "bottom", "top"}},
        Expected{"cylinder",
                 feature("a", "cylinder", {{"radius", 5.0}, {"height", 10.0}}),
                 250 * pi,
                 150 * pi,
                 0,
                 2,
                 3,
                 {"wall", "bottom", "top"}},
        Expected{
            "cone",
            feature("a", "cone", {{"radius_bottom", 6.0}, {"radius_top", 3.0}, {"height", 4.0}}),
            84 * pi,
            90 * pi,
            0,
            2,
            3,
            {"wall", "bottom", "top"}},
        Expected{
            "pointed_cone",
            feature("a", "cone", {{"radius_bottom", 3.0}, {"radius_top", 0.0}, {"height", 4.0}}),
            12 * pi,
            24 * pi,
            1,
            1,
            2,
            {"wall", "bottom"}},
        Expected{
            "cone_on_its_point",
            feature("a", "cone", {{"radius_bottom", 0.0}, {"radius_top", 3.0}, {"height", 4.0}}),
            12 * pi,
            24 * pi,
            1,
            1,
            2,
            {"wall", "top"}},
        Expected{
            "straight_cone",
            feature("a", "cone", {{"radius_bottom", 5.0}, {"radius_top", 5.0}, {"height", 10.0}}),
            250 * pi,
            150 * pi,
            0,
            2,
            3,
            {"wall", "bottom", "top"}},
        Expected{"sphere",
                 feature("a", "sphere", {{"radius", 3.0}}),
                 36 * pi,
                 36 * pi,
                 0,
                 0,
                 1,
                 {"surface"}},
        Expected{"torus",
                 feature("a", "torus", {{"major_radius", 10.0}, {"minor_radius", 2.0}}),
                 80 * pi* pi,
                 80 * pi* pi,
                 0,
                 0,
                 1,
                 {"surface"}},
        Expected{"triangular_prism",
                 feature("a", "prism", {point(0.0, 0.0), point(3.0, 0.0), point(0.0, 4.0)},
                         {{"height", 2.0}}),
                 12,
                 36,
                 6,
                 9,
                 5,
                 {"side1", "side2", "side3", "bottom", "top"}},
        Expected{"clockwise_prism",
                 feature("a", "prism", {point(0.0, 0.0), point(0.0, 4.0), point(3.0, 0.0)},
                         {{"height", 2.0}}),
                 12,
                 36,
                 6,
                 9,
                 5,
                 {"side1", "side2", "side3", "bottom", "top"}},
        Expected{
            "prism_with_an_arc",
            feature("a", "prism", {point(-2.0, 0.0), point(2.0, 0.0), arc(-2.0, 0.0, 0.0, 2.0)},
                    {{"height", 5.0}}),
            10 * pi,
            20 + 14 * pi,
            4,
            6,
            4,
            {"side1", "side2", "bottom", "top"}},
        Expected{"turned_rectangle",
                 feature("a", "revolution",
                         {point(2.0, 0.0), point(4.0, 0.0), point(4.0, 3.0), point(2.0, 3.0)}, {}),
                 36 * pi,
                 60 * pi,
                 0,
                 4,
                 4,
                 {"side1", "side2", "side3", "side4"}},
        Expected{"turned_about_its_own_side",
                 feature("a", "revolution",
                         {point(0.0, 0.0), point(4.0, 0.0), point(4.0, 3.0), point(0.0, 3.0)}, {}),
                 48 * pi,
                 56 * pi,
                 0,
                 2,
                 3,
                 {"side1", "side2", "side3"}},
        Expected{"quarter_turn",
                 feature("a", "revolution",
                         {point(2.0, 0.0), point(4.0, 0.0), point(4.0, 3.0), point(2.0, 3.0)},
                         {{"angle", 90.0}}),
                 9 * pi,
                 15 * pi + 12,
                 8,
                 12,
                 6,
                 {"side1", "side2", "side3", "side4", "start", "end"}},
        // Sides on the axis sweep no face; where the turn is not full they are edges of the model.
        Expected{"piece_of_a_pie",
                 feature("a", "revolution",
                         {point(0.0, 0.0), point(4.0, 0.0), point(4.0, 3.0), point(0.0, 3.0)},
                         {{"angle", 90.0}}),
                 12 * pi,
                 14 * pi + 24,
                 6,
                 9,
                 5,
                 {"side1", "side2", "side3", "start", "end"}},
        Expected{"pie_without_a_piece",
                 feature("a", "revolution",
                         {point(0.0, 3.0), point(0.0, 0.0), point(4.0, 0.0), point(4.0, 3.0)},
                         {{"angle", 270.0}}),
                 36 * pi,
                 42 * pi + 24,
                 6,
                 9,
                 5,
                 {"side2", "side3", "side4", "start", "end"}},
        Expected{"piece_of_a_ball",
                 feature("a", "revolution", {point(0.0, -3.0), arc(0.0, 3.0, 3.0, 0.0)},
                         {{"angle", 90.0}}),
                 9 * pi,
                 18 * pi,
                 2,
                 3,
                 3,
                 {"side1", "start", "end"}},
        Expected{"turned_half_circle_is_a_ball",
                 feature("a", "revolution", {point(0.0, -3.0), arc(0.0, 3.0, 3.0, 0.0)}, {}),
                 36 * pi,
                 36 * pi,
                 0,
                 0,
                 1,
                 {"side1"}},
        Expected{"turned_half_disc_is_half_a_torus",
                 feature("a", "revolution", {point(10.0, -2.0), arc(10.0, 2.0, 12.0, 0.0)}, {}),
                 // Pappus: half a disc with its centroid 4 r / 3 pi out
                 2 * pi*(10 + 8 / (3 * pi)) * 2 * pi,
                 2 * pi*(10 + 4 / pi) * 2 * pi + 2 * pi * 10 * 4,
                 0,
                 2,
                 2,
                 {"side1", "side2"}},
        Expected{"slot",
                 feature("a", "slot", {{"length", 10.0}, {"width", 4.0}, {"height", 3.0}}),
                 3 * (24 + 4 * pi),
                 2 * (24 + 4 * pi) + 3 * (12 + 4 * pi),
                 8,
                 12,
                 6,
                 {"wall", "bottom", "top"}},
        Expected{"slot_as_long_as_wide_to_rounding",
                 feature("a", "slot", {{"length", 10 + 1e-10}, {"width", 10.0}, {"height", 10.0}}),
                 250 * pi,
                 150 * pi,
                 0,
                 2,
                 3,
                 {"wall", "bottom", "top"}}),
    [](const auto& param) { return std::string(param.param.name); });

}  // namespace
}  // namespace remeshd
