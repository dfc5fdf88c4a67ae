#include "client/cli/store_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "client/cli/exit_code.h"

namespace remeshd::cli {
namespace {

class StoreFolder : public testing::Test {
 protected:
  void TearDown() override {
    ::setenv("HOME", home_.c_str(), 1);
    ::unsetenv("XDG_CACHE_HOME");
  }
  std::string home_ = std::getenv("HOME") == nullptr ? "/" : std::getenv("HOME");
};

TEST_F(StoreFolder, FollowsTheXdgCacheRules) {
  ::setenv("HOME", "/home/anna", 1);
  ::setenv("XDG_CACHE_HOME", "/var/tmp/cache", 1);
  EXPECT_EQ(default_store_folder(), "/var/tmp/cache/remeshd");
  ::setenv("XDG_CACHE_HOME", "relative/paths/are/ignored", 1);
  EXPECT_EQ(default_store_folder(), "/home/anna/.cache/remeshd");
  ::unsetenv("XDG_CACHE_HOME");
  EXPECT_EQ(default_store_folder(), "/home/anna/.cache/remeshd");
  ::unsetenv("HOME");
  EXPECT_THROW(default_store_folder(), UsageError);
}

}  // namespace
}  // namespace remeshd::cli
