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
  EXPECT_EQ(here.get("recipe/ab/abc", {}), std::nullopt);
  here.put("recipe/ab/abc", "first");
  EXPECT_TRUE(there.has("recipe/ab/abc", 1));
  EXPECT_EQ(there.get("recipe/ab/abc", {}), "first");
  there.put("recipe/ab/abc", "second");
  EXPECT_EQ(here.get("recipe/ab/abc", {}), "second");
}

TEST_F(FolderObjectsTest, ThatCannotBeMadeAreAnOutageOfTheTier) {
  std::ofstream(folder_.string()) << "a file";
  EXPECT_EQ(error_of([&] { FolderObjects objects(folder_); }).reason, "TIER_UNAVAILABLE");
}

TEST_F(FolderObjectsTest, OfAFileSystemThatIsNotMountedAnyMoreAreAnOutageOfTheTier) {
  FolderObjects objects(folder_);
  EXPECT_TRUE(objects.begun());
  objects.put("recipe/ab/abc", "first");
  const fs::path mounted = folder_.string() + "-mounted";
  fs::rename(folder_, mounted);
  fs::create_directory(folder_);  // the mount point
  const auto look = [&] { static_cast<void>(objects.has("recipe/ab/abc", 1)); };
  EXPECT_EQ(error_of(look).reason, "TIER_UNAVAILABLE");
  EXPECT_NE(error_of(look).message.find("mounted"), std::string::npos);
  EXPECT_EQ(error_of([&] { objects.put("recipe/ab/abd", "second"); }).reason, "TIER_UNAVAILABLE");
  EXPECT_TRUE(fs::is_empty(folder_));
  fs::remove(folder_);
  fs::rename(mounted, folder_);
  EXPECT_EQ(objects.get("recipe/ab/abc", {}), "first");
  EXPECT_FALSE(FolderObjects(folder_).begun());
}

TEST_F(FolderObjectsTest, OfBeforeTheMarkAreNotANewTier) {
  fs::create_directories(folder_ / "recipe/ab");
  std::ofstream(folder_ / "recipe/ab/abc") << "first";
  FolderObjects objects(folder_);
  EXPECT_FALSE(objects.begun());
  EXPECT_EQ(objects.get("recipe/ab/abc", {}), "first");
}

TEST_F(FolderObjectsTest, ThatAreNoFilesAreAnOutageOfTheTier) {
  FolderObjects objects(folder_);
  fs::create_directories(folder_ / "recipe/ab/abc");
  EXPECT_EQ(error_of([&] { static_cast<void>(objects.get("recipe/ab/abc", {})); }).reason,
            "TIER_UNAVAILABLE");
}

}  // namespace
}  // namespace remeshd::test
