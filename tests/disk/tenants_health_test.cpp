#include <gmock/gmock.h>

#include <cerrno>
#include <mutex>
#include <set>
#include <thread>

#include "server/session/tenants.h"
#include "tests/disk/file_calls.h"
#include "tests/server/fake_engine.h"
#include "tests/server/session/answer.h"
#include "tests/server/store/store_folder.h"
#include "tests/support/cases.h"

namespace remeshd::test {
namespace {

/// Two tenants, of whom the store of one finds its disk full.
class TenantsHealth : public StoreFolderTest {
 protected:
  /// Whether the answer says that it is durable.
  bool made(const std::string& tenant, double dx) {
    Answer answer;
    tenants_.of(tenant).make(CreateCommand{.source = model_of({block("plate", dx, 40, 10)}),
                                           .options = {.nodes = 100},
                                           .design = "plate"},
                             answer.listener());
    const Made made = answer.made();
    EXPECT_EQ(made.warnings.empty(), made.filed.durable);
    return made.filed.durable;
  }
  void fill_disk_of(const std::string& tenant) {
    calls_.decide([tenant](const FileCall& call, std::size_t) {
      const bool grows = call.kind == FileCall::Kind::Write || call.kind == FileCall::Kind::Create;
      return grows && call.path.find("tenants/" + tenant + "/") != std::string::npos ? ENOSPC : 0;
    });
  }
  std::vector<std::set<std::string>> heard() {
    const std::scoped_lock lock(mutex_);
    return heard_;
  }

  FileCalls calls_{folder_};
  FakeEngine fake_;
  std::mutex mutex_;
  std::vector<std::set<std::string>> heard_;
  Tenants tenants_{
      fake_.engine(), {}, [this](const std::string& tenant) {
        return std::make_unique<Store>(tenant.empty() ? folder_ : folder_ / "tenants" / tenant);
      }};
};

TEST_F(TenantsHealth, NamesThoseWhoseStoresCannotBeWrittenTo) {
  using Tenants = std::set<std::string>;
  for (const char* tenant : {"anna", "ben"}) tenants_.open(tenant);
  tenants_.on_store_health([this](const std::set<std::string>& unhealthy) {
    const std::scoped_lock lock(mutex_);
    heard_.push_back(unhealthy);
  });
  fill_disk_of("anna");
  EXPECT_FALSE(made("anna", 80));
  EXPECT_TRUE(made("ben", 80));
  EXPECT_EQ(heard(), (std::vector{Tenants{}, Tenants{"anna"}}));
  calls_.decide({});
  for (int k = 0; k < 10000 && heard().size() < 3; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(heard(), (std::vector{Tenants{}, Tenants{"anna"}, Tenants{}}));
}

}  // namespace
}  // namespace remeshd::test
