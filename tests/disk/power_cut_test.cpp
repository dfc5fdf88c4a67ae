#include <gmock/gmock.h>

#include "engine/base/error.h"
#include "tests/disk/file_calls.h"
#include "tests/disk/store_work.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::Eq;

class PowerCut : public StoreOnDisk {
 protected:
  PowerCut() : work_(folder_ / "work"), after_(folder_ / "after") { fs::create_directory(work_); }

  /// Cuts the power after each call, and hands the store that is opened then to `check` with the
  /// number of calls.
  template <typename Check>
  void cut_everywhere(const FileRecord& record, Check&& check) {
    for (std::size_t count = 0; count <= record.calls.size(); ++count)
      for (int attempt = 0; attempt < 2 + tries(4); ++attempt) {
        std::mt19937 random(static_cast<unsigned>(1000 * count) + static_cast<unsigned>(attempt));
        const auto keep = [&] { return attempt < 2 ? attempt == 1 : random() % 2 == 0; };
        fs::remove_all(after_);
        write_after_power_cut(record, count, keep, after_);
        SCOPED_TRACE("power cut after call " + std::to_string(count) + ", attempt " +
                     std::to_string(attempt));
        try {
          Store store(after_);
          check(store, count);
        } catch (const Error& failure) {
          ADD_FAILURE() << failure.what();
        }
        if (HasFailure()) return;
      }
  }

  const fs::path work_, after_;
};

TEST_F(PowerCut, NoAcknowledgedRevisionIsLost) {
  std::vector<StoreState> states{{}};  // after each mark
  std::optional<FileCalls> calls(work_);
  {
    Store store(work_);
    for (const StoreStep& step : steps()) {
      step.run(store);
      calls->mark(states.size());
      states.push_back(state_of(store));
    }
  }
  const FileRecord record = calls->record();
  calls.reset();
  ASSERT_EQ(states.back().revisions, (std::set<int>{1, 2, 3, 4}));
  ASSERT_GT(record.calls.size(), 60U);

  cut_everywhere(record, [&](Store& store, std::size_t count) {
    std::size_t done = 0;
    for (std::size_t i = 0; i < count; ++i)
      if (record.calls[i].kind == FileCall::Kind::Mark) done = record.calls[i].at;
    const StoreState& before = states[done];
    const StoreState& next = states[std::min(done + 1, states.size() - 1)];
    const StoreState found = state_of(store);
    EXPECT_THAT(found.listing, AnyOf(Eq(before.listing), Eq(next.listing)));
    EXPECT_EQ(found.revisions, found.listing == before.listing ? before.revisions : next.revisions);
  });
}

/// Opens what is in `work_`, cuts the power all along, and opens that.
#define EXPECT_OPENING_CAN_BE_CUT(expected)                                                   \
  {                                                                                           \
    std::optional<FileCalls> calls(work_);                                                    \
    { const Store opened(work_); }                                                            \
    const FileRecord record = calls->record();                                                \
    calls.reset();                                                                            \
    EXPECT_GT(record.calls.size(), 3U);                                                       \
    cut_everywhere(record,                                                                    \
                   [&](Store& store, std::size_t) { EXPECT_EQ(state_of(store), expected); }); \
  }

class PowerCutOnOpening : public PowerCut {
 protected:
  PowerCutOnOpening() {
    Store store(work_);
    for (int n = 1; n <= 4; ++n) file(store, n);
    expected_ = state_of(store);
  }
  StoreState expected_;
};

TEST_F(PowerCutOnOpening, AJournalMadeAgainFromPacksLosesNothing) {
  for (const char* name : {"journal.a", "journal.b"}) fs::remove(work_ / name);
  EXPECT_OPENING_CAN_BE_CUT(expected_);
}

TEST_F(PowerCutOnOpening, ADamagedJournalLosesNothing) {
  flip_bit(work_ / "journal.a", 300);
  flip_bit(work_ / "journal.b", 700);
  EXPECT_OPENING_CAN_BE_CUT(expected_);
}

TEST_F(PowerCutOnOpening, ADamagedFormatLosesNothing) {
  flip_bit(work_ / "FORMAT", 12);
  EXPECT_OPENING_CAN_BE_CUT(expected_);
}

}  // namespace
}  // namespace remeshd::test
