#pragma once

#include <gtest/gtest.h>

#include "engine/verify/verify.h"

namespace remeshd::test {

/// That two verifications of a mesh say the same, to the bit but for the rounding of its volume.
inline void expect_same_verdict(const Verification& a, const Verification& b) {
  EXPECT_EQ(a.valid, b.valid);
  EXPECT_EQ(a.counts, b.counts);
  ASSERT_EQ(a.failures.size(), b.failures.size());
  for (std::size_t i = 0; i < a.failures.size(); ++i) {
    EXPECT_EQ(a.failures[i].kind, b.failures[i].kind);
    EXPECT_EQ(a.failures[i].entity, b.failures[i].entity);
    EXPECT_EQ(a.failures[i].place, b.failures[i].place);
  }
  EXPECT_EQ(a.surface, b.surface);
  EXPECT_EQ(a.boundary_facets, b.boundary_facets);
  EXPECT_EQ(a.chord_volume, b.chord_volume);
  EXPECT_EQ(a.boundary_area, b.boundary_area);
  EXPECT_EQ(a.chord_error, b.chord_error);
  EXPECT_NEAR(a.volume, b.volume, 1e-12 * std::fabs(a.volume));
  EXPECT_NEAR(a.volume_error, b.volume_error, 1e-11);
}

}  // namespace remeshd::test
