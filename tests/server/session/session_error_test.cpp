#include "server/session/session_error.h"

#include <gtest/gtest.h>

#include <string>

namespace remeshd {
namespace {

TEST(SessionError, QuotesWhatWasAskedForUpTo160Letters) {
  EXPECT_STREQ(error::revision_not_found("plate@9", "").what(), "there is no revision `plate@9`");
  EXPECT_EQ(error::revision_ambiguous(std::string(200, 'a')).what(),
            "more than one revision's id begins with `" + std::string(160, 'a') + "`");
}

}  // namespace
}  // namespace remeshd
