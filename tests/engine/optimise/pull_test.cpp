#include "engine/optimise/pull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "engine/cellular/cellular_model.h"
#include "engine/nodes/fill/fill.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;

void pull(NodeSet& nodes, const BoundaryModel& boundary, const Samples& samples,
          std::span<const std::uint32_t> active, const PullOptions& options) {
  NearestToPoints nearest(samples.positions(), options.sizes.base());
  pull_boundary(nodes, boundary, Adjacency(boundary), samples, active, nearest, options, kRun);
}

struct Scene {
  FeatureModel model;
  CellularModel cells;
  Membership membership;
  Samples samples;
  std::vector<std::uint32_t> everything;

  Scene(const std::string& name, double l)
      : model(test::case_features(name)),
        cells(build_cells(model, kRun)),
        membership(model),
        samples(sample_boundary(cells.boundary, membership, l, 1, {}, kRun)),
        everything(samples.points.size()) {
    std::iota(everything.begin(), everything.end(), 0U);
  }
  NodeSet random_nodes(std::uint32_t count, double l) const {
    NodeSet nodes;
    for (const Vec3& p : fill_random(
             {membership.bounds()}, [&](const Vec3& q) { return membership.inside(q); },
             {.edge_length = l, .count = count}, kRun))
      nodes.add_new(p);
    return nodes;
  }
};

TEST(PullBoundary, EveryVertexGetsANode) {
  const Scene s("tool3-a", 5);
  NodeSet nodes = s.random_nodes(1200, 5);
  pull(nodes, s.cells.boundary, s.samples, s.everything, {.sizes = 5});
  std::vector<int> at(s.cells.boundary.vertices.size(), 0);
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (nodes.supports[n].kind == Support::Kind::Vertex) {
      ++at[nodes.supports[n].entity];
      EXPECT_EQ(nodes.positions[n], s.cells.boundary.vertices[nodes.supports[n].entity].position);
    }
  for (const int count : at) EXPECT_EQ(count, 1);
}

TEST(PullBoundary, NodesBeyondItsReachStayWhereTheyAre) {
  const Scene s("simple-a", 4);
  const auto moved_by_most = [&](double reach) {
    NodeSet nodes = s.random_nodes(400, 4);
    const NodeSet before = nodes;
    pull(nodes, s.cells.boundary, s.samples, s.everything,
         {.sizes = 4, .split = false, .reach = reach});
    double most = 0;
    for (std::int32_t n = 0; n < before.size(); ++n)
      if (nodes.supports[n].kind != Support::Kind::Vertex)
        most = std::max(most, distance(nodes.positions[n], before.positions[n]));
    return most;
  };
  EXPECT_GT(moved_by_most(HUGE_VAL), 2.5);
  EXPECT_LT(moved_by_most(0.3), 0.3 * 4 * 2);  // faces first, then edges
}

TEST(PullBoundary, PulledNodesStandOnTheirEntityAndTheOthersAreInterior) {
  const Scene s("tool1-a", 5);
  NodeSet nodes = s.random_nodes(1200, 5);
  const NodeSet before = nodes;
  pull(nodes, s.cells.boundary, s.samples, s.everything, {.sizes = 5});
  int boundary = 0;
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    if (nodes.supports[n].kind == Support::Kind::Interior) {
      EXPECT_EQ(nodes.positions[n], before.positions[n]);
      continue;
    }
    ++boundary;
    EXPECT_LT(distance(project(s.cells.boundary, nodes.supports[n], nodes.positions[n]),
                       nodes.positions[n]),
              1e-9);
  }
  EXPECT_GT(boundary, 400);
}

TEST(PullBoundary, FixedNodesStay) {
  const Scene s("simple-a", 8);
  NodeSet nodes = s.random_nodes(600, 8);
  pull(nodes, s.cells.boundary, s.samples, s.everything, {.sizes = 8});
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    nodes.state[n] = nodes.positions[n].x > 0 ? NodeState::Free : NodeState::Fixed;
  const NodeSet before = nodes;
  const std::span faces_and_edges(s.everything.data(), s.samples.vertices_begin);
  pull(nodes, s.cells.boundary, s.samples, faces_and_edges, {.sizes = 8});
  int fixed = 0, fixed_on_boundary = 0, moved = 0;
  for (std::int32_t n = 0; n < before.size(); ++n) {
    if (!before.is_free(n)) {
      ++fixed;
      fixed_on_boundary += before.supports[n].kind != Support::Kind::Interior;
      EXPECT_FALSE(nodes.is_free(n));
      EXPECT_EQ(nodes.positions[n], before.positions[n]);
      EXPECT_EQ(nodes.supports[n], before.supports[n]);
    }
    moved += nodes.positions[n] != before.positions[n];
  }
  EXPECT_GT(fixed, 200);
  EXPECT_GT(fixed_on_boundary, 100);
  EXPECT_GT(moved, 50);
}

TEST(PullBoundary, OfFixedNodesOnlyThoseNearVerticesAreFreed) {
  const Scene s("simple-a", 8);
  NodeSet nodes = s.random_nodes(600, 8);
  std::ranges::fill(nodes.state, NodeState::Fixed);
  const NodeSet before = nodes;
  pull(nodes, s.cells.boundary, s.samples, s.everything, {.sizes = 8});
  int at_vertices = 0;
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    if (!nodes.is_free(n)) {
      EXPECT_EQ(nodes.positions[n], before.positions[n]);
      EXPECT_EQ(nodes.supports[n], before.supports[n]);
      continue;
    }
    ++at_vertices;
    ASSERT_EQ(nodes.supports[n].kind, Support::Kind::Vertex);
    const Vec3& vertex = s.cells.boundary.vertices[nodes.supports[n].entity].position;
    EXPECT_EQ(nodes.positions[n], vertex);
    if (n < before.size()) {  // not a new one, where none was near
      EXPECT_LE(distance(before.positions[n], vertex), PullOptions().vertex_reach * 8);
    }
  }
  EXPECT_EQ(at_vertices, static_cast<int>(s.cells.boundary.vertices.size()));
}

/// What becomes of a fixed node beside or on a vertex when the vertices of the model pull alone.
NodeSet pulled_by_vertices(const Scene& s, NodeSet nodes, double l) {
  std::ranges::fill(nodes.state, NodeState::Fixed);
  const std::span vertices = std::span(s.everything).subspan(s.samples.vertices_begin);
  pull(nodes, s.cells.boundary, s.samples, vertices, {.sizes = l});
  return nodes;
}

TEST(PullBoundary, NodesAtTheInterfaceOfAPatchAreNotTakenForVertices) {
  const Scene s("simple-a", 8);
  const std::size_t vertices = s.cells.boundary.vertices.size();
  const Vec3 beside = s.cells.boundary.vertices[0].position + Vec3{0.5, 0.5, 0.5};
  NodeSet nodes;
  nodes.add_new(beside);
  const NodeSet of_model = pulled_by_vertices(s, nodes, 8);
  EXPECT_EQ(of_model.positions[0], s.cells.boundary.vertices[0].position);
  EXPECT_EQ(of_model.positions.size(), vertices);
  nodes.interface_nodes = 1;
  const NodeSet of_patch = pulled_by_vertices(s, nodes, 8);
  EXPECT_EQ(of_patch.positions[0], beside);
  EXPECT_FALSE(of_patch.is_free(0));
  EXPECT_EQ(of_patch.positions.size(), vertices + 1);
}

TEST(PullBoundary, ANodeOnAVertexIsNotTakenForAnotherVertexNearby) {
  const Scene s("simple-a", 8);
  const auto& vertices = s.cells.boundary.vertices;
  NodeSet nodes;
  nodes.add_new(vertices[0].position, {Support::Kind::Vertex, 0});
  double nearest = HUGE_VAL;
  for (std::size_t v = 1; v < vertices.size(); ++v)
    nearest = std::min(nearest, distance(vertices[v].position, vertices[0].position));
  const double l = 2 * nearest;  // so that other vertices reach for it
  const NodeSet pulled = pulled_by_vertices(s, nodes, l);
  EXPECT_EQ(pulled.positions[0], vertices[0].position);
  EXPECT_EQ(pulled.supports[0], nodes.supports[0]);
  EXPECT_EQ(pulled.positions.size(), vertices.size());
}

TEST(PullBoundary, ANodeBetweenTwoFarSidesIsSplit) {
  // A plate thinner than the edge length: one node in the middle serves neither of its sides.
  FeatureModel model = evaluate(test::one_feature(
      test::feature("plate", "block", {{"dx", 20.0}, {"dy", 20.0}, {"dz", 1.0}})));
  const CellularModel cells = build_cells(model, kRun);
  const Membership membership(model);
  const Samples samples = sample_boundary(cells.boundary, membership, 4, 1, {}, kRun);
  std::vector<std::uint32_t> faces(samples.edges_begin);
  std::iota(faces.begin(), faces.end(), 0U);
  NodeSet nodes;
  for (double x = -8; x <= 8; x += 4)
    for (double y = -8; y <= 8; y += 4) nodes.add_new({x, y, 0.5});
  pull(nodes, cells.boundary, samples, faces, {.sizes = 4});
  EXPECT_GE(nodes.size(), 50);
  int top = 0, bottom = 0;
  for (const Vec3& p : nodes.positions) {
    top += p.z == 1;
    bottom += p.z == 0;
  }
  EXPECT_GE(top, 25);
  EXPECT_GE(bottom, 25);
}

/// The first face of the model that the feature's face covers.
int face_named(const BoundaryModel& boundary, int feature, const std::string& name) {
  for (std::size_t f = 0; f < boundary.faces.size(); ++f)
    if (std::ranges::count(boundary.faces[f].names, FaceName{feature, name}) > 0)
      return static_cast<int>(f);
  ADD_FAILURE() << "no face is named " << name;
  return 0;
}

/// How many pairs of faces or edges meet in each way, which is the same both ways round.
std::map<Meeting, int> meetings(const BoundaryModel& boundary, Support::Kind kind) {
  const Adjacency adjacency(boundary);
  const int all =
      static_cast<int>(kind == Support::Kind::Face ? boundary.faces.size() : boundary.edges.size());
  std::map<Meeting, int> counts;
  for (int a = 0; a < all; ++a)
    for (int b = a + 1; b < all; ++b) {
      const Meeting m = adjacency.meeting(kind, a, b);
      EXPECT_EQ(m, adjacency.meeting(kind, b, a));
      ++counts[m];
    }
  return counts;
}

// A triangle of angles 40, 70 and 70 degrees in plan: only its first corner is sharp.
TEST(Adjacency, TellsBluntFromSharpAndFromApart) {
  const double angle = 40 * std::numbers::pi / 180;
  const FeatureModel model = evaluate(
      test::one_feature(test::feature("wedge", "prism",
                                      {test::point(0.0, 0.0), test::point(20.0, 0.0),
                                       test::point(20 * std::cos(angle), 20 * std::sin(angle))},
                                      {{"height", 10.0}})));
  const BoundaryModel boundary = build_cells(model, kRun).boundary;
  const Adjacency adjacency(boundary);
  const auto meeting = [&](const char* a, const char* b) {
    return adjacency.meeting(Support::Kind::Face, face_named(boundary, 0, a),
                             face_named(boundary, 0, b));
  };
  EXPECT_EQ(meeting("side1", "side3"), Meeting::Sharp);
  EXPECT_EQ(meeting("side1", "side2"), Meeting::Blunt);
  EXPECT_EQ(meeting("side2", "side3"), Meeting::Blunt);
  EXPECT_EQ(meeting("side1", "top"), Meeting::Blunt);
  EXPECT_EQ(meeting("bottom", "top"), Meeting::Apart);
  EXPECT_EQ(
      meetings(boundary, Support::Kind::Face),
      (std::map<Meeting, int>{{Meeting::Apart, 1}, {Meeting::Blunt, 8}, {Meeting::Sharp, 1}}));
  // Three edges at each of six corners; those of the sharp corner above and below meet sharply.
  EXPECT_EQ(
      meetings(boundary, Support::Kind::Edge),
      (std::map<Meeting, int>{{Meeting::Apart, 18}, {Meeting::Blunt, 16}, {Meeting::Sharp, 2}}));
}

TEST(Adjacency, TellsASharpWedgeOfVoid) {
  // A notch of 40 degrees from the middle of a plate out through its side.
  const double across = 40 * std::tan(20 * std::numbers::pi / 180);
  FeatureSource notch =
      test::feature("notch", "prism",
                    {test::point(0.0, 0.0), test::point(40.0, -across), test::point(40.0, across)},
                    {{"height", 10.0}});
  notch.nature = Nature::Subtractive;
  const FeatureModel model = evaluate(test::model_of({test::block("plate", 60, 60, 10), notch}));
  const BoundaryModel boundary = build_cells(model, kRun).boundary;
  const Adjacency adjacency(boundary);
  const int below = face_named(boundary, 1, "side1"), above = face_named(boundary, 1, "side3");
  EXPECT_EQ(adjacency.meeting(Support::Kind::Face, below, above), Meeting::Sharp);
  EXPECT_EQ(adjacency.meeting(Support::Kind::Face, below, face_named(boundary, 0, "top")),
            Meeting::Blunt);
  EXPECT_EQ(meetings(boundary, Support::Kind::Face)[Meeting::Sharp], 1);
}

TEST(Adjacency, TellsASharpWedgeThatACutLeaves) {
  // Of a plate only what lies between its side x = 30 and a line from there at 25 degrees is left;
  // the line meets the side y = 30 at 65.
  const double angle = 25 * std::numbers::pi / 180;
  FeatureSource cut = test::feature(
      "cut", "prism",
      {test::point(30.0, -20.0),
       test::point(30 - 100 * std::sin(angle), 100 * std::cos(angle) - 20),
       test::point(-100.0, 100.0), test::point(-100.0, -100.0), test::point(40.0, -100.0)},
      {{"height", 10.0}});
  cut.nature = Nature::Subtractive;
  const FeatureModel model = evaluate(test::model_of({test::block("plate", 60, 60, 10), cut}));
  const BoundaryModel boundary = build_cells(model, kRun).boundary;
  const Adjacency adjacency(boundary);
  const int slope = face_named(boundary, 1, "side1");
  EXPECT_EQ(adjacency.meeting(Support::Kind::Face, slope, face_named(boundary, 0, "x_max")),
            Meeting::Sharp);
  EXPECT_EQ(adjacency.meeting(Support::Kind::Face, slope, face_named(boundary, 0, "y_max")),
            Meeting::Blunt);
  EXPECT_EQ(meetings(boundary, Support::Kind::Face)[Meeting::Sharp], 1);
}

}  // namespace
}  // namespace remeshd
