#include "server/observe/readiness.h"

#include <gmock/gmock.h>

namespace remeshd::test {
namespace {

using testing::ElementsAre;

TEST(Readinesses, HoldWhileNothingHinders) {
  Readiness readiness;
  EXPECT_TRUE(readiness.ready());
  readiness.set("store", "the disk is full");
  readiness.set("memory", "no room");
  EXPECT_EQ(readiness.why_not(), "memory: no room; store: the disk is full");
  readiness.set("store", "");
  EXPECT_FALSE(readiness.ready());
  readiness.set("memory", "");
  EXPECT_TRUE(readiness.ready());
  EXPECT_EQ(readiness.why_not(), "");
}

TEST(Readinesses, TellTheirStateAndEachChangeOfIt) {
  Readiness readiness;
  std::vector<bool> heard;
  readiness.on_change([&](bool ready, const std::string&) { heard.push_back(ready); });
  readiness.set("store", "the disk is full");
  readiness.set("memory", "no room");
  readiness.set("memory", "");
  readiness.set("store", "");
  EXPECT_THAT(heard, ElementsAre(true, false, true));
  readiness.on_change({});
  readiness.set("store", "the disk is full");
  EXPECT_EQ(heard.size(), 3U);
}

}  // namespace
}  // namespace remeshd::test
