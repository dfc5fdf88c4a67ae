#include "server/session/edit_tail.h"

#include <gtest/gtest.h>

#include "tests/support/expect_error.h"

namespace remeshd {
namespace {

TEST(EditTail, ComesOffAsItWasPutOn) {
  for (const std::string& edit : {std::string(), std::string("{}"), std::string(100000, '\xFF')}) {
    std::string bytes("rev\0ision", 9);
    append_edit(bytes, edit);
    EXPECT_EQ(take_edit(bytes), edit);
    EXPECT_EQ(bytes, std::string("rev\0ision", 9));
  }
}

TEST(EditTail, IsMissedWhereItIsNot) {
  for (std::string bytes : {std::string(), std::string("abc"), std::string(20, '\xFF')})
    EXPECT_EQ(test::error_of([&] { take_edit(bytes); }).reason, "INTERNAL");
}

}  // namespace
}  // namespace remeshd
