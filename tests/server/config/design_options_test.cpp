#include <gmock/gmock.h>

#include <fstream>

#include "server/config/config_error.h"
#include "server/config/configuration.h"
#include "tests/support/temporary_folder.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;

/// Where names of designs are: in a database, or at a replica each.
class DesignOptionsTest : public testing::Test {
 protected:
  DesignOptionsTest() {
    settings_.daemon.listen = {"127.0.0.1:0"};
    settings_.daemon.store = "store";
    settings_.tier.place = "folder";
    settings_.tier.key_file = key_;
    std::ofstream(key_) << "0123456789abcdef\n";
    std::filesystem::permissions(key_, std::filesystem::perms::owner_read);
  }
  [[nodiscard]] std::string wrong() const {
    try {
      check_settings(settings_);
      return "";
    } catch (const ConfigError& why) {
      return why.what();
    }
  }

  const TemporaryFolder folder_;
  const std::filesystem::path key_ = folder_ / "designs-key";
  Settings settings_;
};

TEST_F(DesignOptionsTest, ADatabaseIsToBeOne) {
  settings_.designs.catalogue = "postgresql://remeshd@db/remeshd?passfile=/run/pgpass";
  EXPECT_EQ(wrong(), "");
  settings_.designs.catalogue = "host=db user=remeshd";
  EXPECT_EQ(wrong(), "");
  settings_.designs.catalogue = "postgresql://db/remeshd?colour=blue";
  EXPECT_THAT(wrong(), HasSubstr("catalogue: invalid URI query parameter"));
  settings_.designs.catalogue = "db";
  EXPECT_THAT(wrong(), HasSubstr("catalogue: "));
}

TEST_F(DesignOptionsTest, OtherReplicasTakeATier) {
  settings_.tier = {};
  settings_.designs.catalogue = "postgresql://db/remeshd";
  EXPECT_THAT(wrong(), HasSubstr("catalogue: needs a tier"));
  settings_.designs = {.replicas = {"a:1"}, .replica = "a:1"};
  EXPECT_THAT(wrong(), HasSubstr("replicas: needs a tier"));
}

TEST_F(DesignOptionsTest, AReplicaIsOneOfThem) {
  settings_.designs = {.replicas = {"a:1", "b:1"}, .replica = "b:1"};
  EXPECT_EQ(wrong(), "");
  settings_.designs.replica = "c:1";
  EXPECT_THAT(wrong(), HasSubstr("c:1 is none of the replicas"));
  settings_.designs.replica.clear();
  EXPECT_THAT(wrong(), HasSubstr("go together"));
  settings_.designs.replica = "a:1";
  settings_.designs.catalogue = "postgresql://db/remeshd";
  EXPECT_THAT(wrong(), HasSubstr("with a catalogue"));
}

}  // namespace
}  // namespace remeshd::test
