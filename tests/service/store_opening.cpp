#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>

#include "server/store/store.h"

// How long a store with many revisions takes to open, with its journal and without.
namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// About what a revision of a part of ten features has, most of which does not pack well.
std::string recipe_of(int n) {
  std::mt19937 random(static_cast<unsigned>(n));
  std::string text(1500, ' ');
  for (char& c : text) c = static_cast<char>('a' + random() % 26);
  return text + std::string(2000, 'x');
}

void fill(const fs::path& folder, int revisions) {
  Store store(folder);
  StoredArray mesh{.name = "mesh"};
  mesh.own(std::string(1000, 'x'));
  const StoredArrays arrays{{mesh}};
  for (int n = 1; n <= revisions; ++n) {
    // Their first digits differ, so that they spread over the folders.
    std::string id = std::to_string(n);
    id = std::string(id.rbegin(), id.rend()) + std::string(64 - id.size(), '0');
    RevisionRecord record{.id = id, .model_name = "m", .created_ns = n, .nodes = 7, .tets = 8};
    const auto number = static_cast<std::uint32_t>(n);
    const std::string recipe = recipe_of(n);
    store.put(record, {.design = "d", .number = number, .id = id}, recipe, arrays);
    store.commit([&](Catalogue&) {
      return Transaction{AddRevision{record, Store::packed_recipe(recipe)},
                         AddPlace{"d", number, id}, SetHead{"d", id}};
    });
  }
}

double seconds_to_open(const fs::path& folder, int revisions) {
  const auto start = Clock::now();
  Store store(folder);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const auto found = store.read([](Catalogue& catalogue) { return catalogue.count_revisions(); });
  if (found != static_cast<std::uint32_t>(revisions)) std::printf("only %u are there\n", found);
  return found == static_cast<std::uint32_t>(revisions) ? seconds : 1e9;
}

int run(int revisions, double goal) {
  const fs::path folder =
      fs::temp_directory_path() / ("remeshd-store-opening-" + std::to_string(::getpid()));
  fs::remove_all(folder);
  fill(folder, revisions);
  const double whole = seconds_to_open(folder, revisions);
  for (const char* journal : {"journal.a", "journal.b"}) fs::remove(folder / journal);
  const double from_packs = seconds_to_open(folder, revisions);
  fs::remove_all(folder);
  std::printf("revisions           %d\n", revisions);
  std::printf("opening             %.3f s (goal %.1f)\n", whole, goal);
  std::printf("without a journal   %.3f s\n", from_packs);
  return whole <= goal && from_packs < 1e9 ? 0 : 1;
}

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  int revisions = 10000;
  double goal = 2;
  CLI::App app("Time to open a store");
  app.add_option("--revisions", revisions);
  app.add_option("--goal", goal, "s");
  CLI11_PARSE(app, argc, argv);
  return remeshd::test::run(revisions, goal);
}
