#include "engine/cellular/cellular_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "engine/base/error.h"
#include "engine/model/solid.h"
#include "tests/engine/cellular/simple_features.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

using std::numbers::pi;
using test::case_features;
using test::error_of;

/// Owners by id with nature and volume, so that a failure reads like the paper's Fig. 5.
std::multimap<std::string, double> cells_by_owners(const FeatureModel& model,
                                                   const CellularModel& cells) {
  std::multimap<std::string, double> out;
  for (const Cell& cell : cells.complex().cells) {
    std::string key = cell.positive ? "+" : "-";
    for (const int owner : cell.owners) key += " " + model.features[owner].id;
    out.emplace(key, std::round(cell.volume * 1e6) / 1e6);
  }
  return out;
}

TEST(CellularModelTest, TwoSlotsCutTheBaseOfFigure5IntoFiveCells) {
  const FeatureModel model = case_features("fig5");
  const CellularModel cells = build_cells(model, kRun);
  EXPECT_THAT(cells_by_owners(model, cells),
              ::testing::UnorderedElementsAre(
                  ::testing::Pair("+ base", 51680), ::testing::Pair("- base slot1", 6560),
                  ::testing::Pair("- base slot1 slot2", 1440),
                  ::testing::Pair("- base slot2", 1080), ::testing::Pair("- base slot2", 3240)));
  EXPECT_NEAR(cells.volume, 51680, 1e-6);
}

TEST(CellularModelTest, VolumesOfAllCasesAreExact) {
  for (const test::EditCase& edit : test::seven_cases()) {
    EXPECT_NEAR(build_cells(case_features(edit.original), kRun).volume, edit.original_volume, 1e-6)
        << edit.original;
    EXPECT_NEAR(build_cells(case_features(edit.modified), kRun).volume, edit.modified_volume, 1e-6)
        << edit.modified;
  }
}

TEST(CellularModelTest, TheLastOwnerInHistoryGivesACellItsNature) {
  // The plug stands after the pocket in history, so it fills a patch of it again.
  const CellularModel plugged = cells_of({block("base", {0.0, 0.0, 0.0}, {40, 40, 10}),
                                          minus(cylinder("pocket", {0.0, 0.0, 4.0}, 8, 6)),
                                          cylinder("plug", {0.0, 0.0, 0.0}, 3, 10)});
  EXPECT_NEAR(plugged.volume, 16000 - 6 * 64 * pi + 6 * 9 * pi, 1e-6);
  const CellularModel drilled = cells_of({block("base", {0.0, 0.0, 0.0}, {40, 40, 10}),
                                          cylinder("boss", {0.0, 0.0, 0.0}, 8, 20),
                                          minus(cylinder("hole", {0.0, 0.0, 0.0}, 5, 20))});
  EXPECT_NEAR(drilled.volume, 16000 + 640 * pi - 500 * pi, 1e-6);
  const CellularModel covered = cells_of({block("base", {0.0, 0.0, 0.0}, {40, 40, 10}),
                                          minus(cylinder("hole", {0.0, 0.0, 0.0}, 5, 20)),
                                          cylinder("boss", {0.0, 0.0, 0.0}, 8, 20)});
  EXPECT_NEAR(covered.volume, 16000 + 640 * pi, 1e-6);
}

TEST(CellularModelTest, APointInsideEveryCellBelongsToItsOwners) {
  for (const char* name : {"tool1-a", "tool2-d", "tool3-b", "fig5", "fig11-a"}) {
    const FeatureModel model = case_features(name);
    const Membership membership(model);
    const CellularModel cells = build_cells(model, kRun);
    for (const Cell& cell : cells.complex().cells) {
      std::vector<int> owners;
      membership.owners(cell.inside, owners);
      EXPECT_EQ(owners, cell.owners) << name;
    }
  }
}

TEST(CellularModelTest, AFaceIsBoundaryWhereTheNaturesOnItsSidesDiffer) {
  const CellularModel cells = build_cells(case_features("fig6-a"), kRun);
  double foot = 0, boundary = 0;
  for (const CellFace& face : cells.complex().faces) {
    const auto positive = [&](int c) { return c >= 0 && cells.complex().cells[c].positive; };
    EXPECT_EQ(face.boundary, positive(face.cells[0]) != positive(face.cells[1]));
    (face.boundary ? boundary : foot) += face.area;
  }
  EXPECT_NEAR(foot, 300 + 2 * 16 * pi, 1e-8) << "the feet of rib and knobs";
  EXPECT_NEAR(boundary, cells.area, 1e-9);
}

TEST(CellularModelTest, FeaturesOwnWhatBoundsTheirCellsWhereverItCameFrom) {
  // The base owns the foot of the rib, its edges and vertices, though they are the rib's own.
  const FeatureModel model = case_features("fig6-a");
  const CellularModel cells = build_cells(model, kRun);
  int edges = 0, vertices = 0;
  for (const CellEdge& edge : cells.complex().edges) edges += edge.owners == std::vector{0, 1};
  for (const CellVertex& vertex : cells.complex().vertices)
    vertices += vertex.owners == std::vector{0, 1};
  EXPECT_EQ(edges, 4);
  EXPECT_EQ(vertices, 4);
}

TEST(CellularModelTest, WhereARibIsFlushWithItsBaseTheSplitIsAnEdgeOfTheCellsButNotOfTheModel) {
  const CellularModel cells = build_cells(case_features("fig11-a"), kRun);
  double inner = 0;
  for (const CellEdge& edge : cells.complex().edges)
    if (!edge.boundary) inner += edge.length;
  EXPECT_NEAR(inner, 2 * 10, 1e-9) << "the ends of the rib's foot";
}

TEST(CellularModelTest, TheSameModelInAnotherUnitHasTheSameCells) {
  for (const double unit : {1e-6, 1e-3, 25.4, 1e6}) {
    const auto scaled = [&](double x) { return x * unit; };
    const CellularModel cells =
        cells_of({block("base", {0.0, 0.0, 0.0}, {scaled(80), scaled(50), scaled(15)}),
                  minus(cylinder("hole", {scaled(-20), 0.0, 0.0}, scaled(8), scaled(15)))});
    EXPECT_EQ(cells.complex().cells.size(), 2u);
    EXPECT_NEAR(cells.volume / (unit * unit * unit), 60000 - 960 * pi, 1e-6) << unit;
    EXPECT_EQ(cells.boundary.edges.size(), 14u);
  }
}

TEST(CellularModelTest, FarFromTheOriginVolumesStayExact) {
  const CellularModel cells = cells_of({block("base", {1e5, -2e5, 3e5}, {80, 50, 15}),
                                        minus(cylinder("hole", {1e5, -2e5, 3e5}, 8, 15))});
  EXPECT_NEAR(cells.volume, 60000 - 960 * pi, 1e-4);
}

TEST(CellularModelTest, AModelThatIsAllSubtractedIsEmpty) {
  const ErrorInfo error = error_of([] {
    cells_of(
        {block("a", {0.0, 0.0, 0.0}, {1, 1, 1}), minus(block("b", {0.0, 0.0, -1.0}, {3, 3, 3}))});
  });
  EXPECT_EQ(error.reason, "EMPTY_MODEL");
  EXPECT_EQ(error.kind, ErrorKind::FailedPrecondition);
}

TEST(CellularModelTest, BodiesApartAreDisconnected) {
  const ErrorInfo error = error_of([] {
    cells_of({block("a", {0.0, 0.0, 0.0}, {1, 1, 1}), block("b", {5.0, 0.0, 0.0}, {1, 1, 1}),
              block("small", {-5.0, 0.0, 0.0}, {1, 1, 0.5})});
  });
  EXPECT_EQ(error.reason, "DISCONNECTED_MODEL");
  EXPECT_THAT(error.message, ::testing::HasSubstr("3 pieces"));
  EXPECT_EQ(error.features, FeatureIds{"small"});
  ASSERT_TRUE(error.place);
  EXPECT_NEAR(error.place->x, -5, 0.5);
}

TEST(CellularModelTest, BodiesThatShareAnEdgeOrAVertexOnlyAreDisconnected) {
  for (const double z : {0.0, 1.0}) {
    const ErrorInfo error = error_of([&] {
      cells_of({block("a", {0.0, 0.0, 0.0}, {1, 1, 1}), block("b", {1.0, 1.0, z}, {1, 1, 1})});
    });
    EXPECT_EQ(error.reason, "DISCONNECTED_MODEL") << z;
  }
}

TEST(CellularModelTest, ABodyCutInTwoIsDisconnected) {
  const ErrorInfo error = error_of([] {
    cells_of({block("a", {0.0, 0.0, 0.0}, {10, 1, 1}),
              minus(block("cut", {0.0, 0.0, -1.0}, {1, 3, 3}))});
  });
  EXPECT_EQ(error.reason, "DISCONNECTED_MODEL");
}

TEST(CellularModelTest, ABodyThatTouchesItselfAlongAnEdgeIsRefused) {
  // Two towers on one base whose corners meet in a line.
  const ErrorInfo error = error_of([] {
    cells_of({block("base", {0.0, 0.0, 0.0}, {10, 10, 1}),
              block("t1", {-1.0, -1.0, 1.0}, {2, 2, 3}), block("t2", {1.0, 1.0, 1.0}, {2, 2, 3})});
  });
  EXPECT_EQ(error.reason, "NON_MANIFOLD_MODEL");
  EXPECT_EQ(error.kind, ErrorKind::FailedPrecondition);
  EXPECT_THAT(error.message, ::testing::HasSubstr("(0, 0, 2.5)"));
  EXPECT_EQ(error.features, (FeatureIds{"t1", "t2"}));
}

TEST(CellularModelTest, ABodyThatTouchesItselfAtAVertexIsRefused) {
  // Two holes in a block that meet in one corner.
  const ErrorInfo error = error_of([] {
    cells_of({block("base", {0.0, 0.0, -5.0}, {10, 10, 10}),
              minus(block("c1", {-1.0, -1.0, -2.0}, {2, 2, 2})),
              minus(block("c2", {1.0, 1.0, 0.0}, {2, 2, 2}))});
  });
  EXPECT_EQ(error.reason, "NON_MANIFOLD_MODEL");
  EXPECT_THAT(error.message, ::testing::HasSubstr("at a vertex"));
  EXPECT_EQ(error.features, (FeatureIds{"c1", "c2"}));
}

TEST(CellularModelTest, AHoleThatTouchesAWallFromInsideIsRefused) {
  const ErrorInfo error = error_of([] {
    cells_of({block("base", {0.0, 0.0, 0.0}, {20, 20, 5}),
              minus(cylinder("hole", {5.0, 0.0, 0.0}, 5, 5))});
  });
  EXPECT_THAT(error.reason, ::testing::AnyOf("NON_MANIFOLD_MODEL", "DISCONNECTED_MODEL"));
}

FeatureSource ball(std::string id, std::array<Scalar, 3> origin, double radius) {
  FeatureSource source = test::feature(std::move(id), "sphere", {{"radius", radius}});
  source.placement.origin = std::move(origin);
  return source;
}

TEST(CellularModelTest, ABallThatTouchesAFaceAtAPointIsRefused) {
  const FeatureSource base = block("base", {0.0, 0.0, 0.0}, {20, 20, 10});
  const auto refused = [](std::vector<FeatureSource> features) {
    const ErrorInfo error = error_of([&] { cells_of(std::move(features)); });
    return error.reason + ' ' + test::joined(error.features) + ' ' +
           error.message.substr(std::min(error.message.size(), error.message.find("at a point")));
  };
  EXPECT_EQ(refused({base, minus(ball("cavity", {1.0, 2.0, 7.0}, 3))}),
            "NON_MANIFOLD_MODEL base,cavity at a point at (1, 2, 10)");
  EXPECT_EQ(refused({base, block("wall", {9.0, 0.0, 10.0}, {2, 20, 10}),
                     ball("knob", {5.0, 0.0, 14.0}, 4)}),
            "NON_MANIFOLD_MODEL base,knob at a point at (5, 0, 10)");
  EXPECT_EQ(
      refused({base, minus(ball("c1", {0.0, 0.0, 5.0}, 2)), minus(ball("c2", {3.0, 0.0, 5.0}, 1))}),
      "NON_MANIFOLD_MODEL c1,c2 at a point at (2, 0, 5)");
}

TEST(CellularModelTest, ABallThatTouchesAFaceInsideMaterialOrNearlyIsNot) {
  const FeatureSource base = block("base", {0.0, 0.0, 0.0}, {20, 20, 10});
  const double four = 4 * pi / 3;
  EXPECT_NEAR(cells_of({base, ball("inner", {1.0, 2.0, 7.0}, 3)}).volume, 4000, 1e-6);
  EXPECT_NEAR(cells_of({base, minus(ball("cavity", {1.0, 2.0, 6.9}, 3))}).volume, 4000 - four * 27,
              1e-6);
  // Tangent all round: a rod with a round end.
  EXPECT_NEAR(
      cells_of({cylinder("rod", {0.0, 0.0, 0.0}, 3, 10), ball("end", {0.0, 0.0, 10.0}, 3)}).volume,
      90 * pi + four * 13.5, 1e-4);
}

TEST(CellularModelTest, ACavityInsideIsBoundaryToo) {
  const CellularModel cells = cells_of({block("base", {0.0, 0.0, 0.0}, {20, 20, 20}),
                                        minus(block("cavity", {0.0, 0.0, 5.0}, {4, 4, 4}))});
  EXPECT_NEAR(cells.volume, 8000 - 64, 1e-9);
  EXPECT_EQ(cells.boundary.faces.size(), 12u);
  EXPECT_EQ(cells.boundary.vertices.size(), 16u);
}

TEST(CellularModelTest, WhereARoundFeatureHasItsSeamMakesNoDifference) {
  // With the x axis as it is, the ball runs into the hole's seam and the kernel cannot triangulate
  // the wall: found by random models.
  const auto volume = [](std::optional<std::array<Scalar, 3>> x_axis) {
    FeatureSource ball = test::feature("ball", "sphere", {{"radius", 6.0}});
    ball.placement.origin = {8.0, -2.0, 2.0};
    FeatureSource hole = minus(cylinder("hole", {-2.0, 1.0, 18.0}, 5, 26));
    hole.placement.z_axis = {0.0, 0.0, -1.0};
    hole.placement.x_axis = std::move(x_axis);
    return cells_of({block("base", {0.0, 0.0, 0.0}, {40, 40, 20}), ball, hole}).volume;
  };
  const double expected = volume(std::nullopt);
  EXPECT_GT(expected, 32000 - 450 * pi);
  EXPECT_LT(expected, 32000 - 450 * pi + 288 * pi);
  EXPECT_NEAR(volume(std::array<Scalar, 3>{0.3, 1.0, 0.0}), expected, 1e-5);
  EXPECT_NEAR(volume(std::array<Scalar, 3>{-1.0, 0.2, 0.0}), expected, 1e-5);
}

TEST(CellularModelTest, ThePointInsideOfAThinCurvedCellIsInIt) {
  const FeatureModel model =
      evaluate(test::model_of({cylinder("outer", {0.0, 0.0, 0.0}, 10.02, 20),
                               minus(cylinder("inner", {0.0, 0.0, 0.0}, 10, 20))}));
  const Membership membership(model);
  const CellularModel cells = build_cells(model, kRun);
  for (const Cell& cell : cells.complex().cells) {
    std::vector<int> owners;
    membership.owners(cell.inside, owners);
    EXPECT_EQ(owners, cell.owners);
  }
}

TEST(CellularModelTest, HalfAPieBeginsAndEndsInOneFace) {
  const CellularModel cells = cells_of({test::feature(
      "pie", "revolution",
      {test::point(0.0, 0.0), test::point(4.0, 0.0), test::point(4.0, 3.0), test::point(0.0, 3.0)},
      {{"angle", 180.0}})});
  EXPECT_NEAR(cells.volume, 24 * pi, 1e-9);
  EXPECT_EQ(cells.boundary.faces.size(), 4u);
  EXPECT_EQ(cells.boundary.edges.size(), 6u);
  EXPECT_EQ(cells.boundary.vertices.size(), 4u);
}

TEST(CellularModelTest, AStopRequestEndsIt) {
  std::stop_source stop;
  stop.request_stop();
  remeshd::Run run;
  run.stop = stop.get_token();
  EXPECT_EQ(error_of([&] { build_cells(case_features("tool1-a"), run); }).kind,
            ErrorKind::Cancelled);
}

}  // namespace
}  // namespace remeshd
