#include "server/service/trace_parent.h"

#include <gtest/gtest.h>

namespace remeshd::test {
namespace {

const std::string kTrace = "0af7651916cd43dd8448eb211c80319c";
const std::string kParent = "b7ad6b7169203331";

TEST(TraceParents, AreVersionTraceParentAndFlags) {
  EXPECT_TRUE(is_trace_parent("00-" + kTrace + "-" + kParent + "-01"));
  EXPECT_TRUE(is_trace_parent("cc-" + kTrace + "-" + kParent + "-01"));
  EXPECT_TRUE(is_trace_parent("cc-" + kTrace + "-" + kParent + "-01-what-comes-later"));
}

TEST(TraceParents, OfAnotherFormAreNone) {
  for (const std::string& text :
       {std::string(), "00-" + kTrace + "-" + kParent, "00-" + kTrace + "-" + kParent + "-1",
        "00-" + kTrace + "-" + kParent + "-01-more", "ff-" + kTrace + "-" + kParent + "-01",
        "00_" + kTrace + "_" + kParent + "_01",
        "00-0AF7651916CD43DD8448EB211C80319C-" + kParent + "-01",
        "00-" + std::string(32, '0') + "-" + kParent + "-01",
        "00-" + kTrace + "-" + std::string(16, '0') + "-01",
        "cc-" + kTrace + "-" + kParent + "-01-\nforged=line",
        "cc-" + kTrace + "-" + kParent + "-01-" + std::string(300, 'x')})
    EXPECT_FALSE(is_trace_parent(text)) << text;
}

}  // namespace
}  // namespace remeshd::test
