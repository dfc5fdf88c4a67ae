// Edits that change sizes: what was made for other edge lengths is made anew, and nothing else.
#include "engine/remesh/node_sizes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/remesh/density.h"
#include "engine/remesh/remesh.h"
#include "engine/revision/delaunay_state.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"
#include "tests/support/stored.h"

namespace remeshd {
namespace {

using test::kRun;
const Vec3 kCorner{30, 30, 8};

/// The model's sizes hold, and no rule does.
MeshOptions sized_edit(std::optional<double> size = {}) {
  MeshOptions options{.size = size};
  options.sizing = {.even = false, .edges_per_circle = 0, .layers = 0};
  return options;
}

/// A plate with a hole in the middle.
ModelSource plate_with_hole() {
  return test::model_of(
      {test::block("plate", 60, 60, 8),
       test::placed(test::cylinder("hole", 4, 10), 0, 0, -1, Nature::Subtractive)});
}

SetSize in_corner(double size) {
  return {"spot", BallSource{kCorner.x, kCorner.y, kCorner.z, 2.0}, size};
}

Revision edited(const Revision& base, const Edit& edit, const MeshOptions& options = sized_edit()) {
  return make_revision(base, apply(base.source, {{edit}}), options, kRun);
}

/// Mean length of the mesh's edges near a place.
double edges_near(const Revision& r, const Vec3& place, double reach) {
  const PagedMesh& mesh = r.output.mesh;
  double sum = 0;
  int edges = 0;
  for (const Tet& t : mesh.tets) {
    if (distance(centroid(mesh.nodes, t), place) > reach) continue;
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b, ++edges) sum += distance(mesh.nodes[t[a]], mesh.nodes[t[b]]);
  }
  return sum / edges;
}

/// Of the base's nodes further than `reach` from a place, the share that stayed where it was.
double kept_beyond(const Revision& base, const Revision& r, const Vec3& place, double reach) {
  int far = 0, kept = 0;
  for (const Vec3& p : base.output.mesh.nodes) far += distance(p, place) > reach ? 1 : 0;
  for (std::size_t n = 0; n < r.output.mesh.nodes.size(); ++n)
    kept += r.output.map.node_origin[n] == NodeOrigin::Kept &&
                    distance(r.output.mesh.nodes[n], place) > reach
                ? 1
                : 0;
  return static_cast<double>(kept) / far;
}

TEST(NodeSizes, OfAnEditOfSizesAloneItIsMadeFinerThereAndNowhereElse) {
  const Revision base = make_revision(Revision::none(), plate_with_hole(), sized_edit(4), kRun);
  const Revision fine = edited(base, in_corner(1));
  EXPECT_EQ(fine.report.strategy, MeshStrategy::Local);
  EXPECT_LT(edges_near(fine, kCorner, 3), 0.45 * edges_near(base, kCorner, 3));
  // At .3 a length the field is four fifths of the base's 2 + 2.2 / .3 = 9.3 away.
  EXPECT_GE(kept_beyond(base, fine, kCorner, 24), 0.99);
  EXPECT_GE(fine.report.quality.dihedral_min, 15);
}

TEST(NodeSizes, AnEditOfThemHasAboutAsManyNodesAsAFirstMeshOfThatModel) {
  // Tets as large as half of a sized mesh's took nodes for voids: 54 % more.
  const ModelSource block = test::model_of({test::block("b", 80, 40, 20)});
  const Revision base = make_revision(Revision::none(), block, sized_edit(6), kRun);
  const Revision edit = edited(base, SetSize{"spot", BallSource{0.0, 0.0, 10.0, 4.0}, 1.0});
  const Revision first = make_revision(Revision::none(), edit.source, sized_edit(6), kRun);
  EXPECT_EQ(edit.report.strategy, MeshStrategy::Local);
  EXPECT_NEAR(edit.report.counts.nodes, first.report.counts.nodes,
              0.15 * first.report.counts.nodes);
}

TEST(NodeSizes, WhatStaysWhereSizesChangedIsRightForTheLengthThere) {
  // It counted as made for the length before, and each edit after made the place anew.
  const Revision base = make_revision(Revision::none(), plate_with_hole(), sized_edit(4), kRun);
  Revision next = edited(base, SetFeatureParameter{"hole", "radius", 4.5});
  ASSERT_EQ(next.report.strategy, MeshStrategy::Local);
  ASSERT_GT(next.report.counts.nodes_kept, 0U);
  const CopyPlan plan(base.copied_model(), next.model, copy_lengths(4, false), kRun);
  next.rules_weakening = 2;  // so that lengths may differ anywhere
  next.sizes = SizeField(2);
  for (const double length : made_for(base, next, &plan, kRun).flat()) EXPECT_EQ(length, 2);
  next.sizes = SizeField(3.5);  // not far off
  for (const double length : made_for(base, next, &plan, kRun).flat())
    EXPECT_TRUE(length == 4 || length == 3.5) << length;
}

TEST(NodeSizes, FurtherFromAChangeThanLengthsGrowNothingIsMadeAnew) {
  // Walls were measured by other pieces of a face that a change elsewhere had triangulated anew.
  const Revision base = make_revision(Revision::none(), plate_with_hole(), sized_edit(4), kRun);
  Revision next = edited(base, SetFeatureParameter{"hole", "radius", 4.5});
  ASSERT_EQ(next.report.strategy, MeshStrategy::Local);
  const CopyPlan plan(base.copied_model(), next.model, copy_lengths(4, false), kRun);
  next.sizes = SizeField(2);
  const std::vector<double> lengths = made_for(base, next, &plan, kRun).flat();
  const double reach = (4 - 2) / 0.3;
  int near = 0, far = 0;
  for (std::size_t n = 0; n < lengths.size(); ++n) {
    const Vec3& p = next.output.mesh.nodes[n];
    const double beside = std::fmax(std::fabs(p.x), std::fabs(p.y)) - 4.5;
    if (next.output.map.node_origin[n] != NodeOrigin::Kept) continue;
    if (beside > 1.01 * reach) {
      ++far;
      EXPECT_EQ(lengths[n], 4);
    } else if (beside < 0.99 * reach) {
      ++near;
      EXPECT_EQ(lengths[n], 2);
    }
  }
  EXPECT_GT(near, 0);
  EXPECT_GT(far, near);
  const std::optional<Resized> anew = resized(plan, base, next, *next.sizes, kRun);
  ASSERT_TRUE(anew);
  EXPECT_EQ(anew->plan({25, 25, 4}), plan.identity());
  EXPECT_EQ(anew->plan({8, 0, 4}), CopyPlan::kNew);
  EXPECT_EQ(anew->most_off, 2);
}

TEST(NodeSizes, OfASizeThatIsRemovedItIsMadeCoarserAgain) {
  ModelSource source = plate_with_hole();
  source.sizes = {{"spot", *in_corner(1).place, 1.0}};
  const Revision fine = make_revision(Revision::none(), source, sized_edit(4), kRun);
  const Revision r = edited(fine, RemoveSize{"spot"});
  EXPECT_EQ(r.report.strategy, MeshStrategy::Local);
  EXPECT_GT(edges_near(r, kCorner, 3), 2 * edges_near(fine, kCorner, 3));
  EXPECT_GE(kept_beyond(fine, r, kCorner, 24), 0.99);
}

TEST(NodeSizes, ASmallChangeOfASizeKeepsTheMeshAndManyDoNotCreep) {
  ModelSource source = plate_with_hole();
  source.sizes = {{"spot", *in_corner(1).place, 1.0}};
  Revision r = make_revision(Revision::none(), source, sized_edit(4), kRun);
  const double first = edges_near(r, kCorner, 3);
  double size = 1;
  for (int step = 0; step < 12; ++step) {
    size *= 1.08;
    r = edited(r, in_corner(size));
    if (step < 2) {
      EXPECT_EQ(r.report.strategy, MeshStrategy::Unchanged) << step;
    }
  }
  EXPECT_LT(first, 0.7 * size);
  EXPECT_GT(edges_near(r, kCorner, 3), size);
  // No node was made for a length that is off by more than a quarter, though no step was.
  for (std::size_t n = 0; n < r.output.mesh.nodes.size(); ++n)
    EXPECT_GE(1.25 * (1 + 1e-9) * r.output.node_sizes[n],
              (*r.sizes)(r.delaunay_state->positions()[n]));
}

TEST(NodeSizes, AreKeptWithTheRevision) {
  ModelSource source = plate_with_hole();
  source.sizes = {{"spot", *in_corner(1).place, 1.0}};
  const Revision base = make_revision(Revision::none(), source, sized_edit(4), kRun);
  ASSERT_EQ(base.output.node_sizes.size(), base.output.mesh.nodes.size());
  const Revision once = edited(base, in_corner(1.2));
  const Revision loaded = test::stored_and_loaded(once);
  ASSERT_EQ(loaded.output.node_sizes.size(), once.output.node_sizes.size());
  EXPECT_EQ(edited(loaded, in_corner(1.4)).output.mesh.nodes,
            edited(once, in_corner(1.4)).output.mesh.nodes);
}

TEST(NodeSizes, ThereAreNoneOfAnEvenMesh) {
  EXPECT_TRUE(make_revision(Revision::none(), plate_with_hole(), {.size = 4}, kRun)
                  .output.node_sizes.empty());
}

/// A plate with a boss at `x`.
ModelSource plate_with_boss(double x) {
  return test::model_of(
      {test::block("plate", 80, 40, 10), test::placed(test::block("boss", 10, 10, 10), x, 0, 10)});
}
SetPlacement boss_to(double x) { return {"boss", {.origin = {x, 0.0, 10.0}}}; }

TEST(NodeSizes, OfAFeatureThatMovesInTheSameEditItIsMadeFinerToo) {
  // Its nodes were copied as they were, and counted as made for the new length ever after.
  const Revision base = make_revision(Revision::none(), plate_with_boss(0), sized_edit(5), kRun);
  const SetSize finer{"s", "boss", 1.4};
  const Vec3 middle{20, 0, 15};
  const double alone = edges_near(edited(base, finer), middle - Vec3{20, 0, 0}, 4);
  const Revision both =
      make_revision(base, apply(base.source, {{finer, boss_to(20)}}), sized_edit(), kRun);
  EXPECT_LT(edges_near(both, middle, 4), 1.15 * alone);
  // What moves into a box that is fine is made finer, and coarser when it leaves it.
  const SetSize here{"s", BoxSource{15.0, -5.0, 10.0, 25.0, 5.0, 20.0}, 1.4};
  const Revision in_box = edited(edited(base, here), boss_to(20));
  EXPECT_LT(edges_near(in_box, middle, 4), 1.15 * alone);
  EXPECT_GT(edges_near(edited(in_box, boss_to(-20)), middle - Vec3{40, 0, 0}, 4), 2 * alone);
}

TEST(NodeSizes, OfAModelThatMovesAsAWholeItIsMadeFinerToo) {
  const auto at = [](double x) {
    return test::model_of(
        {test::placed(test::block("plate", 60, 40, 8), x, 0, 0),
         test::placed(test::cylinder("hole", 6, 10), x, 0, -1, Nature::Subtractive)});
  };
  ModelSource moved = at(100);
  moved.sizes = {{"rim", "hole.wall", 1.0}};
  const Revision base = make_revision(Revision::none(), at(0), sized_edit(6), kRun);
  const Revision r = make_revision(base, moved, sized_edit(), kRun);
  EXPECT_LT(edges_near(r, {106, 0, 4}, 3), 0.5 * edges_near(base, {6, 0, 4}, 3));
}

TEST(NodeSizes, ThatWereNotFollowedWhileConnectivityWasHeldAreAfterIt) {
  ModelSource source =
      test::model_of({test::block("plate", 80, 40, 10),
                      test::placed(test::cylinder("hole", 4, 12), 0, 0, -1, Nature::Subtractive)});
  source.parameters = {{"x", 20.0}};
  source.sizes = {{"spot", BallSource{"x", 0.0, 5.0, 5.0}, 1.5}};
  const auto with_spot_at = [&](double x, double hole) {
    ModelSource edited = source;
    edited.parameters[0].value = x;
    edited.features[1].placement.origin[0] = hole;
    return edited;
  };
  MeshOptions options = sized_edit(5);
  options.hold = 1;
  const Revision first = make_revision(Revision::none(), source, options, kRun);
  options.size.reset();
  const Revision held = make_revision(first, with_spot_at(-25, 0), options, kRun);
  EXPECT_EQ(held.output.mesh.tets, first.output.mesh.tets);
  const Revision ended = make_revision(held, with_spot_at(-25, 12), options, kRun);
  const Revision at_once = make_revision(first, with_spot_at(-25, 12), options, kRun);
  EXPECT_LT(edges_near(ended, {-25, 0, 5}, 3), 1.15 * edges_near(at_once, {-25, 0, 5}, 3));
}

TEST(NodeSizes, ThatTheModelAsksForComeOutSo) {
  ModelSource block = test::model_of({test::block("b", 40, 40, 40)});
  for (const double size : {2.0, 2.5, 4.0}) {
    block.sizes = {{"s", "b.*", size}};
    const Revision r = make_revision(Revision::none(), block, sized_edit(8), kRun);
    double sum = 0;
    int edges = 0;
    for (const MeshFacet& facet : r.output.groups.facets)
      for (int k = 0; k < 3; ++k, ++edges)
        sum += distance(r.output.mesh.nodes[facet.nodes[k]],
                        r.output.mesh.nodes[facet.nodes[(k + 1) % 3]]);
    EXPECT_NEAR(sum / edges, size, 0.15 * size);
  }
}

TEST(NodeSizes, ADensityOfAnEditHoldsInItsNewcellsAloneAndIsKept) {
  const Revision base = make_revision(Revision::none(), plate_with_hole(), sized_edit(4), kRun);
  const AddFeature boss{test::placed(test::cylinder("boss", 5, 8), -18, -18, 8), ""};
  const Vec3 middle{-18, -18, 12};
  const Revision dense = edited(base, boss, sized_edit(1.5));
  EXPECT_EQ(dense.edge_length, base.edge_length);
  EXPECT_LT(edges_near(dense, middle, 4), 2);
  EXPECT_GE(kept_beyond(base, dense, {-18, -18, 8}, 24), 0.98);
  // An edit elsewhere goes on from that, also from what was stored.
  const SetFeatureParameter wider{"hole", "radius", 4.4};
  const Revision next = edited(dense, wider);
  EXPECT_GE(kept_beyond(dense, next, {0, 0, 4}, 14), 0.98);
  EXPECT_EQ(edited(test::stored_and_loaded(dense), wider).output.mesh.nodes,
            next.output.mesh.nodes);
}

}  // namespace
}  // namespace remeshd
