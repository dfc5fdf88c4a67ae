#include <filesystem>
#include <fstream>

#include "server/guard/secret_file.h"
#include "tests/server/config/read.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class TierOptions : public testing::Test {
 protected:
  TierOptions() {
    settings_.daemon.store = "store";
    settings_.tier.place = "http://127.0.0.1:9/farm";
    settings_.tier.key_file = secret("key", "0123456789abcdef\n");
  }
  /// A file of this user alone.
  [[nodiscard]] fs::path secret(const std::string& name, const std::string& text) const {
    const fs::path file = folder_.file(name);
    std::ofstream(file) << text;
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    return file;
  }
  [[nodiscard]] std::string wrong() const {
    return complaint([&] { check_settings(settings_); });
  }
  [[nodiscard]] std::string wrong_secret() const {
    try {
      check_settings(settings_);
    } catch (const SecretFileError& why) {
      return why.what();
    }
    return "";
  }

  Folder folder_;
  Settings settings_;
};

TEST_F(TierOptions, AreRightWithAStoreAndAKey) {
  EXPECT_NO_THROW(check_settings(settings_));
  settings_.tier.place = "some/folder";
  EXPECT_NO_THROW(check_settings(settings_));
}

TEST_F(TierOptions, NeedAStore) {
  settings_.daemon.store.clear();
  EXPECT_THAT(wrong(), HasSubstr("needs a store"));
}

TEST_F(TierOptions, NeedAKeyThatIsLongEnoughAndSecret) {
  settings_.tier.key_file = secret("short", "0123456789abcde\n");
  EXPECT_THAT(wrong_secret(), HasSubstr("16 characters"));
  settings_.tier.key_file = secret("open", "0123456789abcdef\n");
  fs::permissions(settings_.tier.key_file, fs::perms::others_read, fs::perm_options::add);
  EXPECT_THAT(wrong_secret(), HasSubstr("others may read"));
  settings_.tier.key_file.clear();
  EXPECT_THAT(wrong(), HasSubstr("tier-key-file"));
}

TEST_F(TierOptions, KnowFoldersAndHttp) {
  settings_.tier.place = "s3://bucket";
  EXPECT_THAT(wrong(), HasSubstr("s3://bucket"));
}

TEST_F(TierOptions, SignForS3WithCredentialsAlone) {
  settings_.tier.s3_region = "eu-west-1";
  EXPECT_THAT(wrong(), HasSubstr("go together"));
  settings_.tier.s3_credentials_file = secret("credentials", "ACCESS SECRET\n");
  EXPECT_NO_THROW(check_settings(settings_));
  settings_.tier.s3_credentials_file = secret("half", "ACCESS\n");
  EXPECT_THAT(wrong_secret(), HasSubstr("two words"));
  settings_.tier.place = "some/folder";
  EXPECT_THAT(wrong(), HasSubstr("is a folder"));
}

}  // namespace
}  // namespace remeshd::test
