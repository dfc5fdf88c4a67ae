#pragma once

#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/server/store/store_folder.h"

namespace remeshd::test {

/// What a store holds: its listing, and the revisions that can be read.
struct StoreState {
  std::string listing;
  std::set<int> revisions;
  friend bool operator==(const StoreState&, const StoreState&) = default;
};

/// Something that is asked of a store, and that it acknowledges by returning.
struct StoreStep {
  const char* name;
  std::function<void(Store&)> run;
};

/// Tests of what a store makes of a disk that fails.
class StoreOnDisk : public StoreFolderTest {
 protected:
  /// Every kind of change that a store knows.
  static const std::vector<StoreStep>& steps() {
    static const std::vector<StoreStep> all{
        {"first", [](Store& store) { file(store, 1); }},
        {"second", [](Store& store) { file(store, 2); }},
        {"another design", [](Store& store) { file(store, 3, "e"); }},
        {"a revision in a second design",
         [](Store& store) {
           store.commit([](Catalogue&) { return Transaction{AddPlace{"e", 2, id(1)}}; });
         }},
        {"a head put back",
         [](Store& store) {
           store.commit([](Catalogue&) { return Transaction{SetHead{"d", id(1)}}; });
         }},
        {"a deletion", [](Store& store) { remove(store, 2); }},
        {"the deleted one again", [](Store& store) { file(store, 2); }},
        {"bytes written again",
         [](Store& store) {
           RevisionRecord same = record(1);
           store.put(same, {.design = "d", .number = 1, .id = id(1)}, "", arrays_of(bytes_of(1)));
         }},
        {"a last one", [](Store& store) { file(store, 4); }}};
    return all;
  }

  /// Reads every revision; a failure where one is listed and cannot be read, or has other bytes.
  static StoreState state_of(Store& store) {
    StoreState state{.listing = listing(store)};
    for (int n = 1; n <= 9; ++n) {
      if (!has(store, n)) continue;
      try {
        if (read(store, n) == bytes_of(n)) {
          state.revisions.insert(n);
        } else {
          ADD_FAILURE() << "wrong bytes of revision " << n;
        }
      } catch (const Error& failure) {
        state.listing += std::to_string(n) + " cannot be read: " + failure.what() + "\n";
      }
    }
    return state;
  }

  /// How often a random choice is tried; more by the environment variable REMESHD_DISK_TRIES.
  static int tries(int usual) {
    const char* more = std::getenv("REMESHD_DISK_TRIES");
    return more != nullptr ? std::atoi(more) : usual;
  }
};

}  // namespace remeshd::test
