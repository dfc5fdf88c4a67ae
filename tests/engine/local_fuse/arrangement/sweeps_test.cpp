#include "engine/local_fuse/arrangement/sweeps.h"

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

std::string no_sweeps_for(std::vector<FeatureSource> features) {
  const FuseInput in(model_of(std::move(features)));
  return reason_of(find_sweeps(in.model, in.membership, in.features));
}

TEST(SweepsTest, WhatIsNoPrismAndNoCylinderIsNotSwept) {
  for (const FeatureSource& f :
       {feature("f", "sphere", {{"radius", 1.0}}),
        feature("f", "cone", {{"radius_bottom", 2.0}, {"radius_top", 1.0}, {"height", 3.0}})})
    EXPECT_EQ(no_sweeps_for({block("b", 4, 4, 4), f}),
              "sweeps: a feature is neither a prism nor a cylinder")
        << f.type;
}

TEST(SweepsTest, CylindersAlongDifferentAxesHaveNoDirectionInCommon) {
  EXPECT_EQ(no_sweeps_for({cylinder("a", 1, 4), cylinder("b", 2, 4)}), "");
  EXPECT_EQ(no_sweeps_for({cylinder("a", 1, 4), turned(cylinder("b", 2, 4), {1, 0, 0}, {0, 1, 0})}),
            "sweeps: no direction is along an axis of every feature");
}

TEST(SweepsTest, NoFeaturesAreNoSweeps) {
  const FuseInput in(model_of({block("b", 4, 4, 4)}));
  EXPECT_EQ(reason_of(find_sweeps(in.model, in.membership, {})), "sweeps: there are no features");
}

}  // namespace
}  // namespace remeshd
