#include "engine/delivery/groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/cellular/cellular_model.h"
#include "tests/support/cases.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using testing::ElementsAre;

using test::kRun;

/// A plate of 40 x 40 x 4 with a hole of radius 5 through its middle, at (20, 20), and an inlay in
/// a corner of it.
class PlateWithHole : public testing::Test {
 protected:
  /// A mesh of these tets; the nodes' supports matter to facets only.
  static PagedMesh mesh_of(std::vector<Vec3> nodes, std::vector<Tet> tets) {
    return paged(TetMesh{std::move(nodes), std::move(tets)});
  }
  MeshGroups named(const PagedMesh& mesh, std::span<const SurfaceFacet> surface = {},
                   std::vector<Support> supports = {}, const CellsBefore& before = {}) const {
    supports.resize(mesh.nodes.size());
    return name_groups(mesh, surface, CowVector(supports), model_, membership_, cells_.boundary,
                       before, kRun);
  }
  /// The face of the boundary that has this name.
  Support face(const std::string& name) const {
    for (int f = 0; f < static_cast<int>(cells_.boundary.faces.size()); ++f)
      for (const FaceName& n : cells_.boundary.faces[f].names)
        if (model_.features[n.feature].id + "." + std::string(n.face) == name)
          return {Support::Kind::Face, f};
    ADD_FAILURE() << "no face " << name;
    return {};
  }

  const FeatureModel model_ = evaluate(
      test::model_of({test::block("plate", 40, 40, 4),
                      test::placed(test::cylinder("hole", 5, 6), 0, 0, -1, Nature::Subtractive),
                      test::placed(test::block("inlay", 10, 10, 4), -15, -15, 0)}));
  const CellularModel cells_ = build_cells(model_, kRun);
  const Membership membership_{model_};
};

TEST_F(PlateWithHole, ATetIsInTheCellOfItsCentroid) {
  const MeshGroups groups = named(mesh_of({{-18, -18, 1},
                                           {-16, -18, 1},
                                           {-18, -16, 1},
                                           {-18, -18, 3},
                                           {12, -18, 1},
                                           {14, -18, 1},
                                           {12, -16, 1},
                                           {12, -18, 3}},
                                          {{0, 1, 2, 3}, {4, 5, 6, 7}}));
  EXPECT_THAT(groups.cell_owners, ElementsAre(ElementsAre("plate"), ElementsAre("plate", "inlay")));
  EXPECT_THAT(groups.tet_cell.flat(), ElementsAre(1, 0));
}

TEST_F(PlateWithHole, ATetWhoseCentroidAChordCutOffIsInTheCellOfTheMaterialBesideIt) {
  // Two of its nodes are on the hole's wall, 120 degrees apart: the centroid is in the hole.
  const MeshGroups groups =
      named(mesh_of({{2.5, -4.33, 1}, {6, 0, 1}, {2.5, 4.33, 1}, {6, 0, 3}}, {{0, 1, 2, 3}}));
  EXPECT_THAT(groups.cell_owners, ElementsAre(ElementsAre("plate")));
}

TEST_F(PlateWithHole, TetsThatHaveTheirCellsStillAreNotLookedAt) {
  MeshGroups then;
  then.cell_owners = {{"inlay"}, {"hole"}, {"plate", "inlay"}};
  then.tet_cell = CowVector<std::int32_t>(std::vector<std::int32_t>{0, 2});
  // The second one is anew: in the plate alone, which comes before what the first one keeps.
  const MeshGroups groups = named(mesh_of({{12, -18, 1}, {14, -18, 1}, {12, -16, 1}, {12, -18, 3}},
                                          {{0, 1, 2, 3}, {0, 1, 2, 3}}),
                                  {}, {}, {&then, {1}});
  EXPECT_THAT(groups.cell_owners, ElementsAre(ElementsAre("plate"), ElementsAre("inlay")));
  EXPECT_THAT(groups.tet_cell.flat(), ElementsAre(1, 0));
}

TEST_F(PlateWithHole, FacetsAreNamedAfterTheFaceUnderThem) {
  const std::vector<SurfaceFacet> surface{{{0, 1, 2}, 0}, {{3, 4, 5}, 0}, {{6, 7, 8}, 0}};
  const Support top = face("plate.top"), wall = face("hole.wall");
  const MeshGroups groups = named(mesh_of({{12, -18, 4},
                                           {14, -18, 4},
                                           {12, -16, 4},
                                           {5, 0, 1},
                                           {5, 0, 3},
                                           {3, 4, 2},
                                           {-18, -18, 4},
                                           {-16, -18, 4},
                                           {-18, -16, 4}},
                                          {{0, 1, 2, 3}}),
                                  surface, {top, top, top, wall, wall, wall, top, top, top});
  EXPECT_THAT(groups.facet_groups,
              ElementsAre(ElementsAre("hole.wall"), ElementsAre("inlay.top", "plate.top"),
                          ElementsAre("plate.top")));
  std::vector<std::int32_t> of;
  for (const MeshFacet& f : groups.facets) of.push_back(f.group);
  EXPECT_THAT(of, ElementsAre(2, 0, 1));
}

}  // namespace
}  // namespace remeshd
