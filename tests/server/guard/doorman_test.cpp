#include "server/guard/doorman.h"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>
#include <vector>

#include "engine/base/error.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

using testing::ElementsAre;

/// A doorman who has tenants prepared.
class DoormanTest : public testing::Test {
 protected:
  DoormanTest() { write("ben 0123456789abcdef\nanna 0123456789abcde1\nben 0123456789abcde2\n"); }
  void write(const std::string& text) const {
    std::ofstream(file()) << text;
    std::filesystem::permissions(file(), std::filesystem::perms(0600));
  }
  [[nodiscard]] std::string file() const { return folder_.file("tokens"); }
  bool knows(const Doorman& doorman, const std::string& token) const {
    try {
      return !doorman.tenant_of("Bearer " + token).empty();
    } catch (const Error&) {
      return false;
    }
  }

  Folder folder_;
  std::vector<std::string> prepared_;
  const Doorman::Prepare prepare_ = [this](const std::string& tenant) {
    if (tenant == "bad") throw std::runtime_error("no store");
    prepared_.push_back(tenant);
  };
};

TEST_F(DoormanTest, EveryTenantOfTheFileIsPreparedOnce) {
  Doorman doorman(file());
  doorman.prepare_with(prepare_);
  EXPECT_THAT(prepared_, ElementsAre("anna", "ben"));
}

TEST_F(DoormanTest, ATenantOfANewFileIsPreparedBeforeItsTokensCount) {
  Doorman doorman(file());
  bool known = true;
  doorman.prepare_with([&](const std::string& tenant) {
    if (tenant == "carl") known = knows(doorman, "carls-first-token");
  });
  write("carl carls-first-token\n");
  doorman.reload();
  EXPECT_FALSE(known);
  EXPECT_EQ(doorman.tenant_of("Bearer carls-first-token"), "carl");
}

TEST_F(DoormanTest, WhereATenantCannotBePreparedTheTokensStay) {
  Doorman doorman(file());
  doorman.prepare_with(prepare_);
  write("anna 0123456789abcde4\nbad 0123456789abcde3\n");
  EXPECT_THROW(doorman.reload(), std::runtime_error);
  EXPECT_TRUE(knows(doorman, "0123456789abcdef"));
  EXPECT_FALSE(knows(doorman, "0123456789abcde4"));
}

TEST_F(DoormanTest, AFileWhoseTenantsCannotBePreparedIsToldAtTheStart) {
  write("bad 0123456789abcde3\n");
  Doorman doorman(file());
  EXPECT_THROW(doorman.prepare_with(prepare_), std::runtime_error);
}

TEST_F(DoormanTest, NothingIsPreparedOnceNobodyIsThereToDoIt) {
  Doorman doorman(file());
  doorman.prepare_with(prepare_);
  doorman.prepare_with({});
  prepared_.clear();
  doorman.reload();
  EXPECT_TRUE(prepared_.empty());
}

}  // namespace
}  // namespace remeshd::test
