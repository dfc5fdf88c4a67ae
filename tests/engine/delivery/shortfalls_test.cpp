#include "engine/delivery/shortfalls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace remeshd {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<WarningCode> codes(const Revision& r) {
  std::vector<WarningCode> all;
  for (const Warning& w : shortfalls(r)) all.push_back(w.code);
  return all;
}

Revision good() {
  Revision r;
  r.options = {.nodes = 1000, .threshold = 0.5};
  r.edge_length = 1;
  r.report.counts.nodes = 1000;
  r.report.quality_away.volume_length_min = 0.5;
  return r;
}

TEST(Shortfalls, AreNoneOfAMeshThatIsAsAimedAt) { EXPECT_THAT(codes(good()), IsEmpty()); }

TEST(Shortfalls, NodesAreComparedWhereANumberWasAskedFor) {
  Revision r = good();
  r.report.counts.nodes = 1100;
  EXPECT_THAT(codes(r), IsEmpty());
  for (const std::uint32_t far : {1101U, 899U}) {
    r.report.counts.nodes = far;
    EXPECT_THAT(codes(r), ElementsAre(WarningCode::NodesFarFromTarget));
  }
  r.options.nodes.reset();
  EXPECT_THAT(codes(r), IsEmpty());
}

TEST(Shortfalls, TheLeastQualityIsHeldAgainstTheAimOfTheCleanUp) {
  Revision r = good();
  r.report.quality_away.volume_length_min = 0.499;
  EXPECT_THAT(codes(r), IsEmpty());
  r.report.quality_away.volume_length_min = 0.48;
  EXPECT_THAT(codes(r), ElementsAre(WarningCode::QualityLow));
  r.options.clean_up = false;
  EXPECT_THAT(codes(r), IsEmpty());
}

TEST(Shortfalls, ChordsAreHeldAgainstTheEdgeLength) {
  Revision r = good();
  r.report.verification.chord_error = 0.2;
  EXPECT_THAT(codes(r), IsEmpty());
  r.report.verification.chord_error = 0.3;
  EXPECT_THAT(codes(r), ElementsAre(WarningCode::ChordsCoarse));
}

}  // namespace
}  // namespace remeshd
