#include "tests/support/changed_places.h"

#include <gtest/gtest.h>

#include "engine/cellular/cellular_model.h"
#include "engine/remesh/remesh.h"
#include "tests/support/cases.h"

namespace remeshd::test {
namespace {

/// What is looked at of a revision, which needs no mesh.
Revision unmeshed(const ModelSource& source) {
  Revision revision;
  revision.model = evaluate(source);
  revision.cells = build_cells(revision.model, remeshd::Run{});
  revision.edge_length = 2;
  return revision;
}

TEST(ChangedPlaces, AreOnTheWallOfAHoleThatComesOrGoes) {
  ModelSource source = model_of({block("block", 60, 40, 40)});
  const Revision whole = unmeshed(source);
  source.features.push_back(placed(cylinder("hole", 3, 42), 0, 0, -1, Nature::Subtractive));
  const Revision holed = unmeshed(source);
  const Vec3 beside{8, 0, 20};  // 5 from the wall, 20 from its ends
  for (const ChangedPlaces& changed : {ChangedPlaces(whole, holed), ChangedPlaces(holed, whole)}) {
    EXPECT_LE(changed.distance_to(beside), 5);
    EXPECT_GT(changed.distance_to(beside), 3.5);
    EXPECT_TRUE(changed.within(beside, 5));
    EXPECT_FALSE(changed.within(beside, 3.5));
  }
}

TEST(ChangedPlaces, AreAllOfWhatWasCutAway) {
  const Revision high = unmeshed(model_of({block("block", 60, 40, 40)}));
  const Revision low = unmeshed(model_of({block("block", 60, 40, 10)}));
  const ChangedPlaces changed(high, low);
  EXPECT_EQ(changed.distance_to({0, 0, 25}), 0);
  EXPECT_TRUE(changed.within({0, 0, 25}, 1));
  EXPECT_GT(changed.distance_to({0, 0, 5}), 3.5);
}

TEST(ChangedPlaces, AreSeenWhereASurfaceMovedByNextToNothing) {
  const Revision low = unmeshed(model_of({block("block", 60, 40, 10)}));
  for (const double by : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const Revision high = unmeshed(model_of({block("block", 60, 40, 10 + by)}));
    EXPECT_LE(ChangedPlaces(low, high).distance_to({0, 0, 8}), 2 + by) << by;
  }
}

TEST(KeptShares, CountNodesThatStayedAndNodesFarFromTheChange) {
  const auto bar = [](double radius) {
    return model_of({block("bar", 100, 12, 6),
                     placed(cylinder("hole", radius, 8), -30, 0, -1, Nature::Subtractive)});
  };
  const Revision base = make_revision(Revision::none(), bar(2), {.nodes = 700}, {});
  const Revision edited = make_revision(base, bar(2.5), {}, {});
  const KeptShares shares = kept_shares(base, edited, 4);
  EXPECT_NEAR(shares.kept * static_cast<double>(base.output.mesh.nodes.size()),
              edited.report.counts.nodes_kept, 1e-6);
  // The bar reaches 20 to the left of the hole and 80 to its right.
  const double reach = 4 * base.edge_length;
  EXPECT_LT(shares.far, (100 - 5 - 1.5 * reach) / 100);
  EXPECT_GT(shares.far, (100 - 5 - 2.5 * reach) / 100);
  EXPECT_EQ(kept_shares(base, base, 4).far, 1);
  EXPECT_EQ(kept_shares(base, edited, 1000).far, 0);
}

}  // namespace
}  // namespace remeshd::test
