#include <gtest/gtest.h>

#include <optional>

#include "server/tier/outbox.h"
#include "server/tier/tier_error.h"
#include "tests/disk/file_calls.h"
#include "tests/disk/store_work.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

using OutboxOnDisk = StoreOnDisk;

TEST_F(OutboxOnDisk, LosesNoNameThatWasAddedBeforeThePowerCut) {
  const std::vector<std::string> names{"one", "two"};
  const fs::path work = folder_ / "work", after = folder_ / "after";
  fs::create_directory(work);
  std::optional<FileCalls> calls(work);
  {
    Outbox outbox(work / "outbox", Outbox::Again::InPlace,
                  [](const std::string&) { throw error::tier_unavailable("it is out", 1); });
    for (std::size_t k = 0; k < names.size(); ++k) {
      outbox.add(names[k]);
      calls->mark(k + 1);
    }
  }
  const FileRecord record = calls->record();
  calls.reset();
  std::size_t added = 0;
  for (std::size_t count = 1; count <= record.calls.size(); ++count) {
    const FileCall& call = record.calls[count - 1];
    if (call.kind != FileCall::Kind::Mark) continue;
    added = call.at;
    fs::remove_all(after);
    write_after_power_cut(
        record, count, [] { return false; }, after);
    for (std::size_t k = 0; k < added; ++k)
      EXPECT_TRUE(fs::exists(after / "outbox" / names[k])) << names[k] << ", " << added;
  }
  EXPECT_EQ(added, names.size());
}

}  // namespace
}  // namespace remeshd::test
