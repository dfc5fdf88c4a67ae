#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "server/store/store.h"

namespace remeshd::test {

/// A folder of its own for a test, with a store's life in it.
class StoreFolderTest : public testing::Test {
 protected:
  StoreFolderTest() {
    static std::atomic<int> counter{0};
    // In memory where that is possible: there fsync costs nothing.
    const std::filesystem::path memory = "/dev/shm";
    folder_ =
        (std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path()) /
        ("remeshd-store-test-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~StoreFolderTest() override { std::filesystem::remove_all(folder_); }

  /// The n-th made-up id.
  static std::string id(int n) {
    std::ostringstream out;
    out << std::hex << (n * 37) % 256;
    std::string start = out.str();
    if (start.size() < 2) start = "0" + start;
    std::string rest = std::to_string(n);
    return start + std::string(62 - rest.size(), '0') + rest;
  }
  static int number_of(const std::string& id) { return std::stoi(id.substr(2)); }
  static RevisionRecord record(int n, const std::string& parent = "") {
    return {.id = id(n),
            .parent = parent,
            .model_name = "m\n\"\xC3\xA4",
            .created_ns = 5 + n,
            .nodes = 7,
            .tets = 8,
            .mid_nodes = 9,
            .bytes = 0};
  }
  static std::string bytes_of(int n) {
    return "revision " + std::to_string(n) + std::string("\0\n", 2) + std::string(200, 'x');
  }
  static StoredArrays arrays_of(const std::string& bytes) {
    StoredArray array{.name = "mesh"};
    array.own(bytes);
    return {{std::move(array)}};
  }

  /// Stores revision n as the next of the design and as its head.
  static void file(Store& store, int n, const std::string& design = "d") {
    std::string parent;
    PlaceRecord place{.design = design, .number = 1, .id = id(n)};
    store.read([&](Catalogue& catalogue) {
      if (const auto now = catalogue.design(design)) {
        place.number = now->next_number;
        parent = now->head;
      }
    });
    RevisionRecord added = record(n, parent);
    const StoredArrays base_arrays =
        parent.empty() ? StoredArrays() : arrays_of(bytes_of(number_of(parent)));
    const Packs::Base base{parent, &base_arrays};
    store.put(added, place, "", arrays_of(bytes_of(n)), parent.empty() ? nullptr : &base);
    store.commit([&](Catalogue& catalogue) {
      Transaction changes{AddRevision{added}, SetHead{design, added.id}};
      const auto places = catalogue.places(added.id);
      const bool there = std::any_of(places.begin(), places.end(),
                                     [&](const PlaceRecord& p) { return p.design == design; });
      if (!there) changes.insert(changes.begin(), AddPlace{design, place.number, added.id});
      return changes;
    });
  }
  static void remove(Store& store, int n) {
    store.commit([&](Catalogue& catalogue) {
      Transaction changes;
      for (const PlaceRecord& place : catalogue.places(id(n)))
        changes.emplace_back(RemovePlace{place.design, place.number});
      changes.emplace_back(RemoveRevision{id(n)});
      return changes;
    });
  }
  static std::string read(Store& store, int n) { return store.get(id(n)).arrays.at(0).flat(); }
  static bool has(Store& store, int n) {
    return store.read([&](Catalogue& c) { return c.revision(id(n)).has_value(); });
  }
  /// `d@1 = 7 head` where the design's first revision is the 7th and its head; a line a place.
  static std::string listing(Store& store) {
    std::string text;
    for (const ListedRevision& row :
         store.read([](Catalogue& c) { return c.list({}, {.limit = 1000000}); }))
      text += row.place.design + "@" + std::to_string(row.place.number) + " = " +
              std::to_string(number_of(row.place.id)) + (row.place.head ? " head\n" : "\n");
    return text;
  }

  /// Every file below the folder with what is in it.
  [[nodiscard]] std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
      if (entry.is_regular_file())
        all[std::filesystem::relative(entry.path(), folder_).string()] = content(entry.path());
    return all;
  }
  static std::string content(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static void write(const std::filesystem::path& file, const std::string& bytes) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << bytes;
  }
  static void flip_bit(const std::filesystem::path& file, std::size_t byte, unsigned bit = 0) {
    std::string bytes = content(file);
    bytes.at(byte) = static_cast<char>(static_cast<unsigned char>(bytes[byte]) ^ (1U << bit));
    write(file, bytes);
  }

  std::filesystem::path folder_;
};

}  // namespace remeshd::test
