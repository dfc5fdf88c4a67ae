#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "server/admission/memory_budget.h"
#include "server/daemon.h"
#include "server/session/archive.h"
#include "server/session/stored_form.h"
#include "server/store/array_codec.h"
#include "server/store/store.h"
#include "tests/support/cases.h"

// What a chain of edits costs in a store: bytes on the disk beside those that changed, time beside
// that in memory, and whether every revision comes back to the bit.
namespace remeshd::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kMemory = std::uint64_t{1} << 30U;

struct Settings {
  int edits = 300;
  std::uint32_t nodes = 15000;
  bool pins = false;  ///< every edit changes the radius of the pins, else a parameter in turn
  int read_every = 1;
  fs::path folder;
};

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Of all threads of this process.
double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Bytes that differ at the same index of the same array, or have none there.
std::size_t changed_bytes(const StoredArrays& before, const StoredArrays& after) {
  std::size_t changed = 0;
  for (const StoredArray& array : after.arrays) {
    const StoredArray* other = before.find(array.name);
    const std::string now = array.flat(), then = other ? other->flat() : std::string();
    const std::size_t common = std::min(now.size(), then.size());
    for (std::size_t i = 0; i < common; ++i) changed += now[i] != then[i];
    changed += now.size() - common;
  }
  return changed;
}

std::uint64_t bytes_below(const fs::path& folder) {
  std::uint64_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) bytes += entry.file_size();
  return bytes;
}

/// The next edit of tool1-a: small steps that stay where the part is sound.
void change(ModelSource& source, int number, bool pins, std::mt19937& random) {
  const auto share = [&] { return static_cast<double>(random() % 1000) / 1000; };
  switch (pins ? 0 : number % 3) {
    case 0:
      parameter(source, "pin_radius") = 3.5 + share();
      break;
    case 1:
      parameter(source, "hole_circle") = 35.75 + share() / 2;
      break;
    default:
      parameter(source, "hole_turn") = share();
      break;
  }
}

int run(const Settings& settings) {
  const Engine engine = production_engine();
  const Run engine_run;
  std::mt19937 random(1);
  std::vector<std::string> ids, contents;
  std::vector<double> durable, in_memory, processor;
  std::size_t changed = 0;
  std::uint64_t first_bytes = 0, largest_edit = 0;
  {
    Store store(settings.folder), none;
    MemoryBudget budget(kMemory), other_budget(kMemory);
    Archive archive(engine, store, budget), memory(engine, none, other_budget);
    HeldRevisionPtr last;
    ModelSource source = case_model("tool1-a");
    for (int n = 0; n <= settings.edits; ++n) {
      if (last) change(source, n, settings.pins, random);
      auto made = std::make_shared<HeldRevision>();
      const MeshOptions options = last ? MeshOptions{} : MeshOptions{.nodes = settings.nodes};
      made->revision =
          engine.make_revision(last ? &last->revision : nullptr, source, options, engine_run);
      std::string id = std::to_string(n);
      id = std::string(64 - id.size(), '0') + id;
      std::reverse(id.begin(), id.end());
      made->record = {.id = id, .parent = last ? last->record.id : ""};
      auto start = Clock::now();
      const double processor_start = processor_milliseconds();
      const Filed filed = archive.file(made, "tool1-a", {});
      durable.push_back(milliseconds_since(start));
      processor.push_back(processor_milliseconds() - processor_start);
      start = Clock::now();
      memory.file(made, "tool1-a", {});
      in_memory.push_back(milliseconds_since(start));
      if (last) memory.remove("tool1-a@" + std::to_string(n), true);

      const StoredArrays arrays = stored_form(engine, *made);
      contents.push_back(content_hash(arrays));
      ids.push_back(id);
      if (last) {
        changed += changed_bytes(stored_form(engine, *last), arrays);
        largest_edit = std::max(largest_edit, filed.record.bytes);
      } else {
        first_bytes = filed.record.bytes;
      }
      last = made;
    }
  }
  const std::uint64_t disk = bytes_below(settings.folder);

  int wrong = 0, read = 0;
  double reading = 0;
  const auto opening = Clock::now();
  Store store(settings.folder);
  const double opened = milliseconds_since(opening);
  MemoryBudget budget(kMemory, kMemory / 4);
  Archive archive(engine, store, budget);
  for (std::size_t n = 0; n < ids.size(); n += static_cast<std::size_t>(settings.read_every)) {
    const auto start = Clock::now();
    const HeldRevisionPtr held = archive.get(ids[n], engine_run);
    reading += milliseconds_since(start);
    wrong += content_hash(stored_form(engine, *held)) != contents[n];
    ++read;
  }

  const double of_edits = static_cast<double>(disk - first_bytes);
  const double ratio = of_edits / static_cast<double>(changed);
  const double share = of_edits / settings.edits / static_cast<double>(first_bytes);
  const double more = median(durable) - median(in_memory);
  std::printf("edits                        %d of tool1-a at %u nodes, %s\n", settings.edits,
              settings.nodes, settings.pins ? "pin_radius" : "three parameters in turn");
  std::printf("first revision               %.3f MB\n", 1e-6 * static_cast<double>(first_bytes));
  std::printf("an edit                      %.3f MB at the mean, %.3f MB at most\n",
              1e-6 * of_edits / settings.edits, 1e-6 * static_cast<double>(largest_edit));
  std::printf("an edit of a first revision  %.3f (goal for pin_radius: .25)\n", share);
  std::printf("changed bytes                %.3f MB an edit\n",
              1e-6 * static_cast<double>(changed) / settings.edits);
  std::printf("disk over changed bytes      %.2f (goal 2.5)\n", ratio);
  std::printf("durable over in memory       %.1f ms (goal 10 at 15,000 nodes)\n", more);
  std::printf("  of it processor time       %.1f ms\n", median(processor));
  std::printf("opening                      %.1f ms\n", opened);
  std::printf("reading one                  %.1f ms\n", reading / read);
  std::printf("read back                    %d, %d of them wrong\n", read, wrong);
  const bool good = wrong == 0 && ratio <= 2.5 && (!settings.pins || share <= 0.25);
  return good ? 0 : 1;
}

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  CLI::App app("Costs of a chain of edits in a store");
  app.add_option("--edits", settings.edits);
  app.add_option("--nodes", settings.nodes);
  app.add_flag("--pins", settings.pins);
  app.add_option("--read-every", settings.read_every);
  app.add_option("--folder", settings.folder,
                 "on the disk to be measured; default: of temporary files");
  CLI11_PARSE(app, argc, argv);
  const std::filesystem::path disk =
      settings.folder.empty() ? std::filesystem::temp_directory_path() : settings.folder;
  settings.folder = disk / ("remeshd-store-chain-" + std::to_string(::getpid()));
  const int result = remeshd::test::run(settings);
  std::filesystem::remove_all(settings.folder);
  return result;
}
