#include "server/transport/descriptor_limit.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace remeshd {
namespace {

class DescriptorLimits : public testing::Test {
 protected:
  DescriptorLimits() { ::getrlimit(RLIMIT_NOFILE, &before_); }
  ~DescriptorLimits() override { ::setrlimit(RLIMIT_NOFILE, &before_); }
  void set_soft(rlim_t files) const {
    const rlimit limit{.rlim_cur = files, .rlim_max = before_.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &limit), 0);
  }
  rlimit before_{};
};

TEST_F(DescriptorLimits, LeaveRoomForTheDaemonsOwnFiles) {
  set_soft(1000);
  EXPECT_EQ(connections_within_descriptors(100), 100U);
  EXPECT_EQ(connections_within_descriptors(744), 744U);
  EXPECT_EQ(connections_within_descriptors(1024), 744U);
  set_soft(100);
  EXPECT_EQ(connections_within_descriptors(1024), 50U);
}

TEST_F(DescriptorLimits, AreRaisedToTheHardOne) {
  set_soft(100);
  raise_descriptor_limit();
  rlimit now{};
  ::getrlimit(RLIMIT_NOFILE, &now);
  EXPECT_EQ(now.rlim_cur, before_.rlim_max);
}

}  // namespace
}  // namespace remeshd
