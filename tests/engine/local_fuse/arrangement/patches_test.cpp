#include "engine/local_fuse/arrangement/patches.h"

#include <gtest/gtest.h>

#include "tests/support/local_fuse.h"

namespace remeshd {
namespace {

using test::block;
using test::cylinder;
using test::feature;
using test::FuseInput;
using test::model_of;
using test::reason_of;
using test::turned;

TEST(PatchesTest, EachFeatureHasADirectionOfItsOwn) {
  const FuseInput in(
      model_of({cylinder("a", 1, 4), turned(cylinder("b", 2, 4), {1, 0, 0}, {0, 1, 0})}));
  const auto patches = find_patches(in.model, in.membership, in.features);
  ASSERT_EQ(reason_of(patches), "");
  EXPECT_EQ(patches->patches.size(), 6U);  // two caps and a wall each
}

TEST(PatchesTest, ASphereHasNone) {
  const FuseInput in(model_of({block("b", 4, 4, 4), feature("s", "sphere", {{"radius", 1.0}})}));
  EXPECT_EQ(reason_of(find_patches(in.model, in.membership, in.features)),
            "sweeps: a feature is neither a prism nor a cylinder");
}

}  // namespace
}  // namespace remeshd
