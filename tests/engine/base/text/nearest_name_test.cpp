#include "engine/base/text/nearest_name.h"

#include <gtest/gtest.h>

namespace remeshd::test {
namespace {

const std::vector<std::string> kNames{"listen", "maxNodes", "maxConnections", "queue", "queueWait"};

TEST(NearestNames, AreThoseWithFewestWrongLetters) {
  EXPECT_EQ(nearest_name("lisetn", kNames), "listen");        // swapped
  EXPECT_EQ(nearest_name("listens", kNames), "listen");       // added
  EXPECT_EQ(nearest_name("queueWalt", kNames), "queueWait");  // replaced
  EXPECT_EQ(nearest_name("quee", kNames), "queue");           // left out
}

TEST(NearestNames, DoNotMindCaseAndDashes) {
  EXPECT_EQ(nearest_name("MAX-NODES", kNames), "maxNodes");
  EXPECT_EQ(nearest_name("max_connections", kNames), "maxConnections");
}

TEST(NearestNames, AreNoneWhereNothingIsSimilar) {
  EXPECT_EQ(nearest_name("zebra", kNames), "");
  EXPECT_EQ(nearest_name("", kNames), "");
  EXPECT_EQ(nearest_name(std::string(1 << 20, 'x'), kNames), "");
}

}  // namespace
}  // namespace remeshd::test
