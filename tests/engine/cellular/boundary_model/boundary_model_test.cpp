#include "engine/cellular/boundary_model/boundary_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

using std::numbers::pi;
using test::case_features;
using ::testing::ElementsAre;

BoundaryModel boundary_of(const std::string& name) {
  return build_cells(case_features(name), kRun).boundary;
}

std::vector<std::string> names(const FeatureModel& model, const BoundaryFace& face) {
  std::vector<std::string> out;
  for (const FaceName& name : face.names)
    out.push_back(model.features[name.feature].id + "." + name.face);
  return out;
}

struct Counts {
  const char* model;
  std::size_t vertices, edges, faces;
};

TEST(BoundaryModelTest, HasTheModelsOwnVerticesEdgesAndFaces) {
  // tool1: discs, holes and pins have rims without vertices; four holes, four pins, bore, hub.
  for (const Counts& c : {Counts{"simple-a", 16, 24, 11}, Counts{"tool1-a", 0, 22, 18},
                          Counts{"tool1-c", 0, 22, 18}, Counts{"tool2-a", 12, 30, 15},
                          Counts{"tool3-a", 24, 44, 21}, Counts{"fig11-a", 16, 26, 11}}) {
    const BoundaryModel b = boundary_of(c.model);
    EXPECT_EQ(b.vertices.size(), c.vertices) << c.model;
    EXPECT_EQ(b.edges.size(), c.edges) << c.model;
    EXPECT_EQ(b.faces.size(), c.faces) << c.model;
  }
}

TEST(BoundaryModelTest, EulersFormulaHoldsForTheUnifiedBoundary) {
  // fig5: a block with two crossing slots is a ball without handles; no face has an inner ring.
  const BoundaryModel b = boundary_of("fig5");
  EXPECT_EQ(b.vertices.size() + b.faces.size(), b.edges.size() + 2);
}

TEST(BoundaryModelTest, CoplanarFacesOfSeveralFeaturesAreOneFaceWithAllTheirNames) {
  const FeatureModel model = case_features("fig11-a");
  int flush = 0;
  for (const BoundaryFace& face : build_cells(model, kRun).boundary.faces) {
    if (std::fabs(face.area - 1400) > 1e-6) continue;
    ++flush;
    EXPECT_THAT(names(model, face), ::testing::AnyOf(ElementsAre("rib.y_min", "base.y_min"),
                                                     ElementsAre("rib.y_max", "base.y_max")))
        << "the latest owner first";
  }
  EXPECT_EQ(flush, 2);
}

TEST(BoundaryModelTest, OwnersOnTheMaterialSideComeFirst) {
  // The hole's mouth is flush with the plate, so where a plug stands in it both tops coincide; the
  // hole, though later than the plate, owns no material there.
  ModelSource source;
  source.name = "plugged";
  source.features = {test::feature("plate", "block", {{"dx", 20.0}, {"dy", 20.0}, {"dz", 4.0}}),
                     test::feature("hole", "cylinder", {{"radius", 5.0}, {"height", 4.0}}),
                     test::feature("plug", "cylinder", {{"radius", 5.0}, {"height", 4.0}})};
  source.features[1].nature = Nature::Subtractive;
  const FeatureModel model = evaluate(source);
  const BoundaryModel b = build_cells(model, kRun).boundary;
  ASSERT_EQ(b.faces.size(), 6u) << "plug and plate are one block";
  for (const BoundaryFace& face : b.faces) {
    if (std::fabs(face.area - 400) > 1e-6) continue;
    EXPECT_THAT(names(model, face),
                ::testing::AnyOf(ElementsAre("plug.top", "hole.top", "plate.top"),
                                 ElementsAre("plug.bottom", "hole.bottom", "plate.bottom")));
  }
}

TEST(BoundaryModelTest, AFaceThatOneSubtractiveFeatureMadeHasItsNameAlone) {
  const FeatureModel model = case_features("tool1-a");
  int walls = 0;
  for (const BoundaryFace& face : build_cells(model, kRun).boundary.faces)
    for (const std::string hole : {"hole1", "hole2", "hole3", "hole4"})
      if (names(model, face).front() == hole + ".wall") {
        EXPECT_THAT(names(model, face), ElementsAre(hole + ".wall"));
        EXPECT_TRUE(face.reversed) << "out of the material is towards the axis";
        EXPECT_EQ(face.surface.kind, Surface::Kind::Cylinder);
        EXPECT_EQ(face.surface.r1, 5) << "the user's own number";
        EXPECT_NEAR(face.area, 2 * pi * 5 * 12, 1e-9);
        ++walls;
      }
  EXPECT_EQ(walls, 4);
}

TEST(BoundaryModelTest, TheRimOfAHoleIsAClosedEdgeWithoutVertex) {
  const BoundaryModel b = boundary_of("tool1-a");
  for (const BoundaryEdge& edge : b.edges) {
    EXPECT_EQ(edge.start, -1);
    EXPECT_TRUE(edge.closed());
    EXPECT_EQ(edge.curve.kind, Curve::Kind::Circle);
    EXPECT_NEAR(edge.length, 2 * pi * edge.curve.radius, 1e-9);
    for (const Vec3& p : edge.points)
      EXPECT_NEAR(distance(p, edge.curve.origin), edge.curve.radius, 1e-12);
  }
}

TEST(BoundaryModelTest, ReferencesAreMutual) {
  for (const char* name : {"simple-a", "tool2-d", "tool3-a"}) {
    const BoundaryModel b = boundary_of(name);
    for (int e = 0; e < static_cast<int>(b.edges.size()); ++e) {
      const BoundaryEdge& edge = b.edges[e];
      for (const int f : edge.faces) EXPECT_TRUE(std::ranges::binary_search(b.faces[f].edges, e));
      for (const int v : {edge.start, edge.end})
        EXPECT_TRUE(v < 0 || std::ranges::binary_search(b.vertices[v].edges, e));
      EXPECT_TRUE(edge.start < 0 || edge.points.front() == b.vertices[edge.start].position);
      EXPECT_TRUE(edge.end < 0 || edge.points.back() == b.vertices[edge.end].position);
      EXPECT_LE(edge.start, edge.end);
    }
    double area = 0;
    for (const BoundaryFace& face : b.faces) area += face.area;
    EXPECT_NEAR(area, build_cells(case_features(name), kRun).area, 1e-8);
  }
}

/// Everything but names and triangles, which follow the features.
bool same_geometry(const BoundaryModel& a, const BoundaryModel& b) {
  if (a.vertices.size() != b.vertices.size() || a.edges.size() != b.edges.size() ||
      a.faces.size() != b.faces.size())
    return false;
  for (std::size_t i = 0; i < a.vertices.size(); ++i)
    if (distance(a.vertices[i].position, b.vertices[i].position) > 1e-9) return false;
  for (std::size_t i = 0; i < a.edges.size(); ++i)
    if (a.edges[i].start != b.edges[i].start || a.edges[i].end != b.edges[i].end ||
        a.edges[i].faces != b.edges[i].faces ||
        std::fabs(a.edges[i].length - b.edges[i].length) > 1e-9)
      return false;
  for (std::size_t i = 0; i < a.faces.size(); ++i)
    if (a.faces[i].edges != b.faces[i].edges || std::fabs(a.faces[i].area - b.faces[i].area) > 1e-9)
      return false;
  return true;
}

TEST(BoundaryModelTest, OrderIsByGeometryWhateverTheOrderOfFeatures) {
  ModelSource source = test::case_model("tool1-a");
  const BoundaryModel before = build_cells(evaluate(source), kRun).boundary;
  std::reverse(source.features.begin() + 3, source.features.end());  // pins and holes
  EXPECT_TRUE(same_geometry(before, build_cells(evaluate(source), kRun).boundary));
}

TEST(BoundaryModelTest, TheSameModelGivesTheSameBits) {
  for (const char* name : {"tool1-a", "tool2-d"}) {
    const BoundaryModel a = boundary_of(name), b = boundary_of(name);
    ASSERT_EQ(a.faces.size(), b.faces.size());
    for (std::size_t i = 0; i < a.faces.size(); ++i) {
      EXPECT_EQ(a.faces[i].points, b.faces[i].points);
      EXPECT_EQ(a.faces[i].triangles, b.faces[i].triangles);
      EXPECT_EQ(a.faces[i].names, b.faces[i].names);
    }
    for (std::size_t i = 0; i < a.edges.size(); ++i)
      EXPECT_EQ(a.edges[i].points, b.edges[i].points);
  }
}

TEST(BoundaryModelTest, WhereAPlaneCutsARoundFaceAskewTheEdgeIsOnBothAndHasTwoVertices) {
  // tool2-d: the stiffener's slope runs into the pipe in a piece of an ellipse.
  const BoundaryModel b = boundary_of("tool2-d");
  int other = 0;
  for (const BoundaryEdge& edge : b.edges) {
    if (edge.curve.kind != Curve::Kind::Other) continue;
    ++other;
    EXPECT_GE(edge.start, 0);
    EXPECT_NE(edge.start, edge.end);
    std::set<Surface::Kind> kinds;
    for (const int f : edge.faces) {
      kinds.insert(b.faces[f].surface.kind);
      for (const Vec3& p : edge.points)
        EXPECT_NEAR(signed_distance(b.faces[f].surface, p), 0, 1e-10);
    }
    EXPECT_EQ(kinds, (std::set{Surface::Kind::Plane, Surface::Kind::Cylinder}));
  }
  EXPECT_EQ(other, 1);
}

}  // namespace
}  // namespace remeshd
