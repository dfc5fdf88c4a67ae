#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using Capabilities = DaemonTest;

TEST_F(Capabilities, TellWhatTheDaemonDoes) {
  const v1::ServerCapabilities can = info().capabilities();
  EXPECT_THAT(
      can.capabilities(),
      testing::ElementsAre(
          v1::ServerCapabilities::CAPABILITY_SIZING, v1::ServerCapabilities::CAPABILITY_SIZES,
          v1::ServerCapabilities::CAPABILITY_GROUPS, v1::ServerCapabilities::CAPABILITY_AUDIT,
          v1::ServerCapabilities::CAPABILITY_FORECAST,
          v1::ServerCapabilities::CAPABILITY_MESH_DELTA, v1::ServerCapabilities::CAPABILITY_REMAKE,
          v1::ServerCapabilities::CAPABILITY_CACHE, v1::ServerCapabilities::CAPABILITY_HOLD,
          v1::ServerCapabilities::CAPABILITY_VELOCITIES));
  EXPECT_THAT(can.orders(), testing::ElementsAre(1, 2));
  EXPECT_EQ(can.arrays_size(), 28);
  EXPECT_THAT(can.formats(), testing::ElementsAre("vtu", "msh", "inp", "step"));
}

}  // namespace
}  // namespace remeshd::test
