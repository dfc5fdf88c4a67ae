#include "engine/local_fuse/arrangement/slabs.h"

#include <gtest/gtest.h>

#include "tests/support/local_fuse.h"

namespace remeshd {
namespace {

using test::block;
using test::FuseInput;
using test::model_of;
using test::placed;
using test::reason_of;

Tried<Slabs> slabs_of(const FuseInput& in) {
  const auto sweeps = find_sweeps(in.model, in.membership, in.features);
  if (!sweeps) return sweeps.why();
  const auto arrangement = arrange(*sweeps, in.membership, in.diagonal);
  if (!arrangement) return arrangement.why();
  return Slabs::find(*sweeps, *arrangement, in.membership, in.diagonal);
}

TEST(SlabsTest, HeightsThatNearlyCoincideAreGivenUp) {
  const auto with_step_at = [](double z) {
    const FuseInput in(
        model_of({block("plate", 20, 20, 2), placed(block("step", 5, 4, 4), 0, 0, z)}));
    const auto slabs = slabs_of(in);
    return slabs ? std::to_string(slabs->heights()) + " heights" : reason_of(slabs);
  };
  EXPECT_EQ(with_step_at(1), "4 heights");
  EXPECT_EQ(with_step_at(2), "3 heights");
  EXPECT_EQ(with_step_at(2 - 1e-7),
            "slabs: two heights are neither clearly the same nor clearly apart");
}

TEST(SlabsTest, VeryManySlabsBesideVeryManyEdgesAreGivenUp) {
  const FuseInput any(model_of({block("any", 1, 1, 1)}));
  Sweeps sweeps;
  for (int k = 0; k < 250; ++k) sweeps.sweeps.push_back({.low = 2.0 * k, .high = 2.0 * k + 1});
  PlanarArrangement arrangement;
  arrangement.pieces.resize(100);
  EXPECT_EQ(reason_of(Slabs::find(sweeps, arrangement, any.membership, 500)),
            "slabs: there are too many slabs beside too many edges of the arrangement");
}

}  // namespace
}  // namespace remeshd
