#include <gmock/gmock.h>

#include "engine/base/error.h"
#include "tests/disk/store_work.h"

namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

class BitFlips : public StoreOnDisk {
 protected:
  /// A file below the folder and a bit of it, each bit of the store as likely.
  static std::pair<std::string, std::size_t> any_bit(
      const std::map<std::string, std::string>& files, std::mt19937& random) {
    std::size_t all = 0;
    for (const auto& [name, bytes] : files) all += bytes.size();
    std::size_t at = random() % (8 * all);
    for (const auto& [name, bytes] : files) {
      if (at < 8 * bytes.size()) return {name, at};
      at -= 8 * bytes.size();
    }
    return {};
  }
};

TEST_F(BitFlips, NoneServesWrongBytesOrLosesARevisionOrItsPlace) {
  const fs::path whole = folder_ / "whole", flipped = folder_ / "flipped";
  StoreState expected;
  {
    Store store(whole);
    for (const StoreStep& step : steps()) step.run(store);
    expected = state_of(store);
  }
  const auto before = [&] {
    std::map<std::string, std::string> all;
    for (const auto& [name, bytes] : files()) all[name.substr(6)] = bytes;
    return all;
  }();
  std::mt19937 random(7);
  int damaged = 0;
  for (int attempt = 0; attempt < tries(200); ++attempt) {
    fs::remove_all(flipped);
    fs::copy(whole, flipped, fs::copy_options::recursive);
    const auto [name, bit] = any_bit(before, random);
    flip_bit(flipped / name, bit / 8, bit % 8);
    SCOPED_TRACE("bit " + std::to_string(bit) + " of " + name);
    Store store(flipped);
    StoreState found = state_of(store);
    // A damaged pack is told, and is stored again by the request that made its revision.
    if (found != expected) {
      EXPECT_THAT(name, testing::StartsWith("packs/"));
      // Of what stands on it too.
      EXPECT_LT(found.revisions.size(), expected.revisions.size());
      ++damaged;
      for (const int n : expected.revisions) {
        RevisionRecord same = record(n);
        if (!found.revisions.contains(n))
          store.put(same, {.design = "d", .number = 1, .id = id(n)}, "", arrays_of(bytes_of(n)));
      }
      found = state_of(store);
    }
    EXPECT_EQ(found.listing, expected.listing);
    EXPECT_EQ(found.revisions, expected.revisions);
    if (HasFailure()) break;
  }
  EXPECT_GT(damaged, tries(200) / 10);
}

}  // namespace
}  // namespace remeshd::test
