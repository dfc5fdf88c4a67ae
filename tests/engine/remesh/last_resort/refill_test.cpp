#include "engine/remesh/last_resort/refill.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "engine/remesh/remesh.h"
#include "engine/revision/delaunay_state.h"
#include "tests/support/cases.h"
#include "tests/support/expect_error.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::placed;

using test::kRun;

ModelSource plate_with_a_hole() {
  return test::model_of(
      {block("plate", 40, 20, 6), placed(cylinder("hole", 4, 8), 0, 0, -1, Nature::Subtractive)});
}

/// A mesh that is valid, and said to be wrong somewhere. All of it may be made anew.
struct Faulty {
  Revision revision;
  StitchedMesh whole;
  Verification verification;
  TetMesh patch;

  explicit Faulty(const ModelSource& source)
      : revision(make_revision(Revision::none(), source, {.nodes = 2000}, kRun)) {
    whole.mesh = revision.output.mesh;
    whole.delaunay_state = *revision.delaunay_state;
    patch = {whole.mesh.nodes.flat(), whole.mesh.tets.flat()};
    whole.new_tets.resize(patch.tets.size());
    std::iota(whole.new_tets.begin(), whole.new_tets.end(), 0);
    verification = verify(whole.mesh, whole.delaunay_state.supports, revision.cells.boundary,
                          revision.cells.volume, kRun);
  }
  [[nodiscard]] std::variant<RefilledMesh, std::string> refilled(const Vec3& place) const {
    return refill({whole, verification, patch, std::span(&place, 1), {}}, revision.cells.boundary,
                  *revision.sizes, 2, kRun);
  }
};

/// Without the nodes that are in no tet any more it is valid, but for shapes.
void expect_whole(const Faulty& faulty, const RefilledMesh& refilled) {
  std::vector<Support> supports = faulty.whole.delaunay_state.supports.flat();
  supports.insert(supports.end(), refilled.supports.begin(), refilled.supports.end());
  ASSERT_EQ(supports.size(), refilled.mesh.nodes.size());
  const Verification v = verify(refilled.mesh, supports, faulty.revision.cells.boundary,
                                faulty.revision.cells.volume, kRun);
  for (const MeshDefect& defect : v.failures)
    EXPECT_TRUE(defect.kind == MeshFailure::OrphanNode || defect.kind == MeshFailure::BadTet)
        << defect.what;
}

void expect_refilled(const Faulty& faulty, const Vec3& place) {
  const auto made = faulty.refilled(place);
  ASSERT_TRUE(std::holds_alternative<RefilledMesh>(made)) << std::get<std::string>(made);
  const auto& refilled = std::get<RefilledMesh>(made);
  // Every other tet is as it was.
  const double l = faulty.revision.edge_length;
  std::size_t anew = 0;
  for (std::size_t k = 0; k < refilled.was.size(); ++k) {
    if (refilled.was[k] < 0) {
      ++anew;
      EXPECT_LT(distance(centroid(refilled.mesh.nodes, refilled.mesh.tets[k]), place), 5 * l);
    } else {
      EXPECT_EQ(refilled.mesh.tets[k], faulty.patch.tets[refilled.was[k]]);
    }
  }
  EXPECT_GT(anew, 20U);
  EXPECT_LT(anew, refilled.was.size() / 3);
  expect_whole(faulty, refilled);
}

TEST(Refill, WhatIsWrongInsideAndAtTheBoundaryAlone) {
  const Faulty faulty(plate_with_a_hole());
  expect_refilled(faulty, {10, 0, 3});
  expect_refilled(faulty, {10, 0, 6});
  expect_refilled(faulty, {4, 0, 6});
  expect_refilled(faulty, {20, 10, 6});
}

TEST(Refill, WhatIsNotThePatchsIsNotTouched) {
  Faulty faulty(plate_with_a_hole());
  const Vec3 place{10, 0, 3};
  std::vector<std::int32_t> in_patch;
  std::vector<Tet> elsewhere;
  TetMesh patch{faulty.patch.nodes, {}};
  for (const std::int32_t t : faulty.whole.new_tets) {
    const Tet& tet = faulty.patch.tets[t];
    if (centroid(faulty.patch.nodes, tet).x < place.x) {
      in_patch.push_back(t);
      patch.tets.push_back(tet);
    } else {
      elsewhere.push_back(tet);
    }
  }
  faulty.patch = patch;
  faulty.whole.new_tets = in_patch;
  const auto made = faulty.refilled(place);
  ASSERT_TRUE(std::holds_alternative<RefilledMesh>(made)) << std::get<std::string>(made);
  auto refilled = std::get<RefilledMesh>(made);
  EXPECT_GT(std::ranges::count(refilled.was, -1), 10);
  refilled.mesh.tets.insert(refilled.mesh.tets.end(), elsewhere.begin(), elsewhere.end());
  expect_whole(faulty, refilled);
}

// A pocket whose floor is a film: refused before there was a local last resort.
class AFilm : public testing::Test {
 protected:
  static ModelSource plate(double floor) {
    return test::model_of({block("plate", 40, 30, 6),
                           placed(cylinder("pocket", 5, 10), -10, 0, floor, Nature::Subtractive),
                           placed(cylinder("hole", 3, 8), 12, 0, -1, Nature::Subtractive)});
  }
  const MeshOptions options_{.nodes = 3000, .sizing = {.even = false}};
};

TEST_F(AFilm, IsBridgedWithoutCleanUp) {
  const MeshOptions options{.nodes = 1500, .clean_up = false, .sizing = options_.sizing};
  const Revision base = make_revision(Revision::none(), plate(2), options, kRun);
  const Revision film =
      make_revision(base, plate(1e-3), {.clean_up = false, .sizing = options_.sizing}, kRun);
  EXPECT_GT(film.report.last_resort_share, 0);
  EXPECT_TRUE(
      verify(film.output.mesh, film.supports(), film.cells.boundary, film.cells.volume, kRun)
          .valid);
}

TEST_F(AFilm, IsBridgedByAnEditThatKeepsTheRest) {
  const Revision base = make_revision(Revision::none(), plate(2), options_, kRun);
  const Revision film = make_revision(base, plate(1e-3), {.sizing = options_.sizing}, kRun);
  EXPECT_EQ(film.report.strategy, MeshStrategy::Local);
  EXPECT_GT(film.report.last_resort_share, 0);
  EXPECT_LT(film.report.last_resort_share, 0.3);
  EXPECT_GT(film.report.counts.nodes_kept, 0.4 * film.report.counts.nodes);
  EXPECT_LT(film.report.counts.nodes, 2 * base.report.counts.nodes);

  // Elsewhere the loop goes on as if nothing was.
  ModelSource wider = plate(1e-3);
  wider.features[2].parameters["radius"] = 3.3;
  const Revision next = make_revision(film, wider, {.sizing = options_.sizing}, kRun);
  EXPECT_GT(next.report.counts.nodes_kept, 0.7 * next.report.counts.nodes);
  EXPECT_GT(next.report.last_resort_share, 0);
}

TEST_F(AFilm, WhereWhateverFillsItIsFlatIsRefusedByPlaceAfterTwoAttempts) {
  // More attempts went on, each with four more tries, in vain.
  const Revision base = make_revision(Revision::none(), plate(2), options_, kRun);
  const ErrorInfo info =
      test::error_of([&] { make_revision(base, plate(1e-6), {.sizing = options_.sizing}, kRun); });
  EXPECT_EQ(info.reason, "BOUNDARY_NOT_RECOVERED");
  EXPECT_THAT(info.features, testing::UnorderedElementsAre("pocket", "plate"));
  EXPECT_TRUE(info.place);
  const auto tries = [&](const std::string& row) {
    return std::ranges::count_if(
        info.attempts, [&](const std::string& attempt) { return attempt.starts_with(row); });
  };
  EXPECT_EQ(tries("local, 4 edge lengths, refilled"), 1);
  EXPECT_EQ(tries("local, refined, refilled"), 1);
  EXPECT_EQ(tries("local, everywhere"), 0);
  EXPECT_EQ(tries("fresh"), 0);
  EXPECT_EQ(tries("TetGen"), 0);
}

TEST_F(AFilm, AllOverThePartIsNoPlaceToBeRefilled) {
  // A core that all but fills its bore: refill after refill of half of the mesh took minutes.
  const auto bar = [](double core) {
    return test::model_of({cylinder("bar", 10, 30),
                           placed(cylinder("bore", 8, 40), 0, 0, -5, Nature::Subtractive),
                           cylinder("core", core, 30), placed(cylinder("base", 9, 2), 0, 0, -1)});
  };
  const MeshOptions coarse{.nodes = 1000, .sizing = options_.sizing};
  const Revision base = make_revision(Revision::none(), bar(6), coarse, kRun);
  const ErrorInfo info =
      test::error_of([&] { make_revision(base, bar(7.99), {.sizing = coarse.sizing}, kRun); });
  EXPECT_EQ(info.reason, "BOUNDARY_NOT_RECOVERED");
  // Either wall of the film.
  EXPECT_THAT(info.features, testing::AnyOf(testing::Contains("core"), testing::Contains("bore")));
  ASSERT_FALSE(info.attempts.empty());
  EXPECT_THAT(info.attempts.front(),
              testing::StartsWith("local, 4 edge lengths, refilled: too much is wrong"));
  EXPECT_THAT(info.attempts, testing::Each(testing::Not(testing::StartsWith("fresh"))));
}

TEST_F(AFilm, IsBridgedInAFirstMesh) {
  const Revision film = make_revision(Revision::none(), plate(2e-3), options_, kRun);
  EXPECT_NE(film.report.strategy, MeshStrategy::TetGen);
  EXPECT_GT(film.report.last_resort_share, 0);
  EXPECT_LT(film.report.last_resort_share, 0.5);
}

}  // namespace
}  // namespace remeshd
