#include <gmock/gmock.h>

#include <cerrno>
#include <functional>
#include <optional>
#include <vector>

#include "engine/base/error.h"
#include "tests/disk/file_calls.h"
#include "tests/disk/store_work.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

/// What a fault does to one call, and maybe to all after it.
struct Fault {
  const char* name;
  int error;  ///< as FileCalls::Decide returns it
  bool lasting;
};

class DiskFaults : public StoreOnDisk, public testing::WithParamInterface<Fault> {
 protected:
  DiskFaults() : work_(folder_ / "work"), after_(folder_ / "after") { fs::create_directory(work_); }

  /// The fault, from call `at` on. Sets `reached` when it strikes.
  static FileCalls::Decide fault_at(std::size_t at, bool& reached) {
    return [at, &reached, fault = GetParam(), short_write = std::size_t{0}](
               const FileCall& call, std::size_t index) mutable {
      if (index < at) return 0;
      // After half a write the rest fails.
      if (index == short_write && short_write > 0) return std::abs(fault.error);
      if (index > at && !fault.lasting) return 0;
      reached = true;
      if (fault.error < 0 && call.kind == FileCall::Kind::Write) short_write = index + 1;
      return fault.error;
    };
  }

  /// Runs the steps with the fault at call `at`; false if there are fewer calls.
  bool run_with_fault(std::size_t at) {
    fs::remove_all(work_);
    fs::create_directory(work_);
    std::optional<FileCalls> calls(work_);
    bool reached = false;
    calls->decide(fault_at(at, reached));
    std::set<int> expected, given_up;
    try {
      Store store(work_);
      for (const StoreStep& step : steps()) {
        const StoreState before = state_of(store);
        try {
          step.run(store);
        } catch (const Error& failure) {
          EXPECT_THAT(failure.info().reason, testing::AnyOf("STORE_FAILED", "STORE_FULL"));
          // What failed did not happen.
          EXPECT_EQ(state_of(store).listing, before.listing) << step.name;
        }
      }
      acknowledged_ = state_of(store);
      calls->decide({});
      // The fault is gone: the store takes revisions again, in this process too.
      if (reached) {
        file(store, 9);
        acknowledged_ = state_of(store);
        EXPECT_TRUE(acknowledged_.revisions.contains(9));
      }
    } catch (const Error& failure) {
      EXPECT_THAT(failure.info().reason, testing::AnyOf("STORE_FAILED", "STORE_FULL"));
      acknowledged_ = {};
    }
    record_ = calls->record();
    return reached;
  }

  const fs::path work_, after_;
  StoreState acknowledged_;
  FileRecord record_;
};

TEST_P(DiskFaults, NoAcknowledgedRevisionIsLostWhereverTheyStrike) {
  std::size_t at = 0;
  for (; run_with_fault(at); ++at) {
    SCOPED_TRACE("fault at call " + std::to_string(at));
    {
      Store store(work_);
      const StoreState found = state_of(store);
      for (const int n : acknowledged_.revisions)
        EXPECT_TRUE(found.revisions.contains(n)) << n << " in\n" << found.listing;
      EXPECT_THAT(found.listing, testing::Not(testing::HasSubstr("cannot be read")));
    }
    // And the power goes at the end, with all, nothing or some of what was not synced.
    for (int attempt = 0; attempt < 2 + tries(1); ++attempt) {
      std::mt19937 random(static_cast<unsigned>(1000 * at) + static_cast<unsigned>(attempt));
      const auto keep = [&] { return attempt < 2 ? attempt == 1 : random() % 2 == 0; };
      fs::remove_all(after_);
      write_after_power_cut(record_, record_.calls.size(), keep, after_);
      Store store(after_);
      const StoreState found = state_of(store);
      for (const int n : acknowledged_.revisions)
        EXPECT_TRUE(found.revisions.contains(n)) << n << " after a power cut, in\n"
                                                 << found.listing;
      EXPECT_THAT(found.listing, testing::Not(testing::HasSubstr("cannot be read")));
    }
    if (HasFailure()) break;
  }
  EXPECT_GT(at, 40U);
}

TEST_P(DiskFaults, NoAcknowledgedRevisionIsLostWhereverTheyStrikeAnOpening) {
  const fs::path whole = folder_ / "whole";
  StoreState expected;
  {
    Store store(whole);
    for (int n = 1; n <= 4; ++n) file(store, n);
    remove(store, 3);
    expected = state_of(store);
  }
  const std::vector<std::function<void()>> damages{
      [] {}, [&] { fs::remove(work_ / "journal.a"); }, [&] { flip_bit(work_ / "journal.b", 300); },
      [&] {
        for (const char* name : {"journal.a", "journal.b"}) fs::remove(work_ / name);
      },
      [&] { flip_bit(work_ / "FORMAT", 12); }};
  for (std::size_t d = 0; d < damages.size(); ++d) {
    std::size_t at = 0;
    for (bool reached = true; reached; ++at) {
      SCOPED_TRACE("damage " + std::to_string(d) + ", fault at call " + std::to_string(at));
      fs::remove_all(work_);
      fs::copy(whole, work_, fs::copy_options::recursive);
      damages[d]();
      reached = false;
      {
        FileCalls calls(work_);
        calls.record_opening();
        calls.decide(fault_at(at, reached));
        try {
          const Store store(work_);
        } catch (const Error& failure) {
          EXPECT_THAT(failure.info().reason, testing::AnyOf("STORE_FAILED", "STORE_FULL"));
        }
      }
      Store store(work_);
      const StoreState found = state_of(store);
      if (d == 0) {
        EXPECT_EQ(found, expected);
      }
      EXPECT_THAT(found.revisions, testing::IsSupersetOf(expected.revisions)) << found.listing;
      // Without a journal the head is what the packs that could be read make of it.
      if (d != 3) {
        EXPECT_THAT(found.listing, testing::HasSubstr("d@4 = 4 head"));
      }
      if (HasFailure()) return;
    }
    EXPECT_GT(at, 5U);
  }
}

INSTANTIATE_TEST_SUITE_P(, DiskFaults,
                         testing::Values(Fault{"OneInputOutputError", EIO, false},
                                         Fault{"OneFullDisk", ENOSPC, false},
                                         Fault{"OneShortWrite", -ENOSPC, false},
                                         Fault{"InputOutputErrorsFromThen", EIO, true},
                                         Fault{"FullDiskFromThen", -ENOSPC, true}),
                         [](const auto& test) { return test.param.name; });

class StoreCalls : public StoreOnDisk {
 protected:
  StoreCalls() { file(store_, 7); }

  FileCalls calls_{folder_};  // before the store opens its files
  Store store_{folder_};
};

TEST_F(StoreCalls, APackAndItsNamesAreSyncedBeforeTheJournalAndItsLineBeforeTheReturn) {
  using Kind = FileCall::Kind;
  const std::size_t before = calls_.record().calls.size();
  file(store_, 8);
  std::vector<FileCall> calls = calls_.record().calls;
  calls.erase(calls.begin(), calls.begin() + static_cast<std::ptrdiff_t>(before));
  std::vector<std::string> order;
  for (const FileCall& call : calls) {
    const std::string where = call.path.substr(0, call.path.find('/'));
    if (call.kind == Kind::Write) order.push_back("write " + where);
    if (call.kind == Kind::Sync) order.push_back("sync " + where);
    if (call.kind == Kind::Rename) order.push_back("rename to " + call.to.substr(0, 5));
  }
  // File, its folder and the folder of that, at the same time.
  EXPECT_THAT(order, testing::ElementsAre("write packs", "sync packs", "sync packs", "sync packs",
                                          "write journal.a", "sync journal.a", "write journal.b"));
}

TEST_F(StoreCalls, APackInAFolderOfBeforeWaitsForTwoSyncsAndForTheJournal) {
  const std::string same_folder = id(7).substr(0, 2);
  ASSERT_EQ(id(7 + 256).substr(0, 2), same_folder);
  const std::size_t before = calls_.record().calls.size();
  file(store_, 7 + 256);
  std::multiset<std::string> synced;
  const FileRecord record = calls_.record();
  for (std::size_t i = before; i < record.calls.size(); ++i)
    if (record.calls[i].kind == FileCall::Kind::Sync) synced.insert(record.calls[i].path);
  EXPECT_EQ(synced, (std::multiset<std::string>{
                        "packs/" + same_folder,
                        "packs/" + same_folder + "/" + id(7 + 256).substr(2), "journal.a"}));
}

TEST_F(StoreCalls, APackIsMarkedUntilItIsWrittenAndNotAnyMoreOnceItIsSynced) {
  const fs::path pack = folder_ / "packs" / id(8).substr(0, 2) / id(8).substr(2);
  std::vector<std::string> marked;
  calls_.decide([&](const FileCall& call, std::size_t) {
    if (folder_ / call.path != pack || call.kind == FileCall::Kind::Create) return 0;
    marked.emplace_back(call.kind == FileCall::Kind::Write ? "write " : "sync ");
    marked.back() += is_being_written(pack) ? "marked" : "unmarked";
    return 0;
  });
  file(store_, 8);
  calls_.decide({});
  EXPECT_THAT(marked, testing::ElementsAre("write marked", "sync unmarked"));
}

TEST_F(StoreCalls, APackThatCannotBeWrittenLeavesNoFile) {
  for (const auto kind : {FileCall::Kind::Create, FileCall::Kind::Write, FileCall::Kind::Sync}) {
    calls_.decide([&](const FileCall& call, std::size_t) { return call.kind == kind ? EIO : 0; });
    EXPECT_THROW(file(store_, 8), Error);
    calls_.decide({});
    EXPECT_FALSE(fs::exists(folder_ / "packs" / id(8).substr(0, 2) / id(8).substr(2)));
  }
}

TEST_F(StoreCalls, APackThatCannotBeReplacedLeavesTheOneOfBeforeAndNoScratchFile) {
  for (const auto kind : {FileCall::Kind::Write, FileCall::Kind::Sync, FileCall::Kind::Rename}) {
    calls_.decide([&](const FileCall& call, std::size_t) { return call.kind == kind ? EIO : 0; });
    RevisionRecord same = record(7);
    EXPECT_THROW(
        store_.put(same, {.design = "d", .number = 1, .id = id(7)}, "", arrays_of("other")), Error);
    calls_.decide({});
    EXPECT_TRUE(fs::is_empty(folder_ / "tmp"));
    EXPECT_EQ(read(store_, 7), bytes_of(7));
  }
}

TEST_F(StoreCalls, APackThatAFailedSyncLeftIsWrittenAnewAndNotBelieved) {
  const fs::path pack = folder_ / "packs" / id(8).substr(0, 2) / id(8).substr(2);
  calls_.decide([&](const FileCall& call, std::size_t) {
    const bool ours = call.path == fs::relative(pack, folder_).string();
    const bool fails = call.kind == FileCall::Kind::Sync || call.kind == FileCall::Kind::Unlink;
    return ours && fails ? EIO : 0;
  });
  EXPECT_THROW(file(store_, 8), Error);
  calls_.decide({});
  ASSERT_TRUE(fs::exists(pack));
  file(store_, 8);
  // With nothing of what was written before the failed sync on the disk.
  const fs::path after = folder_ / "after";
  const FileRecord record = calls_.record();
  write_after_power_cut(
      record, record.calls.size(), [] { return false; }, after);
  Store store(after);
  EXPECT_EQ(read(store, 8), bytes_of(8));
}

TEST_F(StoreCalls, HalfALineOfAFailedWriteIsCutOffBeforeTheNextOne) {
  const std::string before = content(folder_ / "journal.a");
  int seen = 0;
  calls_.decide([&](const FileCall& call, std::size_t) {
    if (call.path != "journal.a" || call.kind != FileCall::Kind::Write) return 0;
    return ++seen == 1 ? -ENOSPC : ENOSPC;
  });
  EXPECT_THROW(file(store_, 8), Error);
  EXPECT_EQ(seen, 2);
  EXPECT_EQ(content(folder_ / "journal.a"), before);
  EXPECT_FALSE(fs::exists(folder_ / "packs" / id(8).substr(0, 2) / id(8).substr(2)));
  calls_.decide({});
  file(store_, 6);
  EXPECT_TRUE(content(folder_ / "journal.a").starts_with(before));
  EXPECT_EQ(content(folder_ / "journal.a"), content(folder_ / "journal.b"));
}

class StoreCallsAfterAFailedSync : public StoreCalls {
 protected:
  StoreCallsAfterAFailedSync() {
    calls_.decide([&](const FileCall& call, std::size_t) {
      return call.path == "journal.a" && call.kind == FileCall::Kind::Sync ? EIO : 0;
    });
    EXPECT_THROW(file(store_, 8), Error);
    calls_.decide({});
  }
};

TEST_F(StoreCallsAfterAFailedSync, TheBytesStayAsLongAsTheDiskMayHaveTheLine) {
  const fs::path after = folder_ / "after";
  const FileRecord record = calls_.record();
  write_after_power_cut(
      record, record.calls.size(), [] { return true; }, after);
  Store store(after);
  EXPECT_TRUE(has(store, 8));
  EXPECT_THAT(state_of(store).listing, testing::Not(testing::HasSubstr("cannot be read")));
}

TEST_F(StoreCallsAfterAFailedSync, TheJournalIsWrittenAnew) {
  const std::size_t before = calls_.record().calls.size();
  file(store_, 6);
  std::vector<std::string> renamed;
  const FileRecord record = calls_.record();
  for (std::size_t i = before; i < record.calls.size(); ++i)
    if (record.calls[i].kind == FileCall::Kind::Rename) renamed.push_back(record.calls[i].to);
  EXPECT_THAT(renamed, testing::IsSupersetOf({"journal.a", "journal.b"}));
  EXPECT_FALSE(has(store_, 8));
}

}  // namespace
}  // namespace remeshd::test
