#include "server/tier/folder_objects.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "engine/base/error.h"
#include "tests/support/expect_error.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

class FolderObjectsTest : public testing::Test {
 protected:
  ~FolderObjectsTest() override { fs::remove_all(folder_); }
  const fs::path folder_ =
      fs::temp_directory_path() / ("remeshd-objects-test-" + std::to_string(::getpid()));
};

TEST_F(FolderObjectsTest, AreThereForWhoeverOpensTheFolder) {
  FolderObjects here(folder_), there(folder_);
  EXPECT_FALSE(here.has("recipe/ab/abc", 1));
  EXPECT_EQ(here.get("recipe/ab/abc"), std::nullopt);
  here.put("recipe/ab/abc", "first");
  EXPECT_TRUE(there.has("recipe/ab/abc", 1));
  EXPECT_EQ(there.get("recipe/ab/abc"), "first");
  there.put("recipe/ab/abc", "second");
  EXPECT_EQ(here.get("recipe/ab/abc"), "second");
}

TEST_F(FolderObjectsTest, ThatCannotBeMadeAreAnOutageOfTheTier) {
  std::ofstream(folder_.string()) << "a file";
  EXPECT_EQ(error_of([&] { FolderObjects objects(folder_); }).reason, "TIER_UNAVAILABLE");
}

TEST_F(FolderObjectsTest, ThatAreNoFilesAreAnOutageOfTheTier) {
  FolderObjects objects(folder_);
  fs::create_directories(folder_ / "recipe/ab/abc");
  EXPECT_EQ(error_of([&] { static_cast<void>(objects.get("recipe/ab/abc")); }).reason,
            "TIER_UNAVAILABLE");
}

}  // namespace
}  // namespace remeshd::test
