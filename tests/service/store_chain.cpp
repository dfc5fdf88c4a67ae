#include <unistd.h>

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
#include "tests/service/goals.h"
#include "tests/service/load_program.h"
#include "tests/service/timing.h"
#include "tests/support/cases.h"

// What a chain of edits costs in a store: bytes on the disk beside those that changed, time beside
// that in memory, and whether every revision comes back to the bit, also once half of the meshes'
// bytes have gone from the disk.
namespace remeshd::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMemory = std::uint64_t{1} << 30U;

struct Settings {
  int edits = 300;
  std::uint32_t nodes = 15000;
  bool pins = false;  ///< every edit changes the radius of the pins, else a parameter in turn
  int read_every = 1;
  fs::path folder;
  bool goals = false;
};

double milliseconds_since(Clock::time_point start) { return 1000 * seconds_since(start); }

/// Of all threads of this process.
double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

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

/// Makes the next edit of tool1-a: a small step that stays where the part is sound. Returns its
/// document.
std::string change(ModelSource& source, int number, bool pins, std::mt19937& random) {
  const double share = static_cast<double>(random() % 1000) / 1000;
  const auto set = [&](const std::string& name, double value) {
    parameter(source, name) = value;
    return R"({"edits": [{"setParameter": {"name": ")" + name + R"(", "value": )" +
           std::to_string(value) + "}}]}";
  };
  if (pins || number % 3 == 0) return set("pin_radius", 3.5 + share);
  if (number % 3 == 1) return set("hole_circle", 35.75 + share / 2);
  return set("hole_turn", share);
}

class Chain {
 public:
  explicit Chain(const Settings& settings) : settings_(settings), goals_(settings.goals) {}

  int run() {
    make();
    const std::uint64_t disk = bytes_below(settings_.folder);
    tell_costs(disk);
    read_back(disk);
    return goals_.exit_status();
  }

 private:
  void make();
  HeldRevisionPtr next(const HeldRevisionPtr& last, int number);
  /// Files it in both, and takes the times.
  void file(const HeldRevisionPtr& made, Archive& archive, Archive& memory);
  void compare(const HeldRevisionPtr& last, const HeldRevisionPtr& made);
  void tell_costs(std::uint64_t disk);
  void read_back(std::uint64_t disk);
  void read_all(Archive& archive, const std::string& what);

  const Settings settings_;
  const Engine engine_ = production_engine();
  const Run run_{};
  Goals goals_;
  std::mt19937 random_{1};
  ModelSource source_ = case_model("tool1-a");
  std::vector<std::string> ids_, contents_;
  std::vector<double> durable_, in_memory_, processor_, new_tets_, changed_share_;
  std::size_t changed_ = 0;
  std::uint64_t first_bytes_ = 0, largest_edit_ = 0;
};

HeldRevisionPtr Chain::next(const HeldRevisionPtr& last, int number) {
  auto made = std::make_shared<HeldRevision>();
  if (last) made->edit = change(source_, number, settings_.pins, random_);
  const MeshOptions options = last ? MeshOptions{} : MeshOptions{.nodes = settings_.nodes};
  made->asked = options;
  made->revision = engine_.make_revision(last ? &last->revision : nullptr, source_, options, run_);
  std::string id = std::to_string(number);
  id = std::string(64 - id.size(), '0') + id;
  std::reverse(id.begin(), id.end());
  made->record = {.id = id,
                  .parent = last ? last->record.id : "",
                  .algorithm_version = engine_.algorithm_version};
  return made;
}

void Chain::file(const HeldRevisionPtr& made, Archive& archive, Archive& memory) {
  auto start = Clock::now();
  const double processor_start = processor_milliseconds();
  const Filed filed = archive.file(made, "tool1-a", {});
  durable_.push_back(milliseconds_since(start));
  processor_.push_back(processor_milliseconds() - processor_start);
  start = Clock::now();
  memory.file(made, "tool1-a", {});
  in_memory_.push_back(milliseconds_since(start));
  if (ids_.empty())
    first_bytes_ = filed.record.bytes;
  else
    largest_edit_ = std::max(largest_edit_, filed.record.bytes);
}

void Chain::compare(const HeldRevisionPtr& last, const HeldRevisionPtr& made) {
  const StoredArrays arrays = stored_form(engine_, *made);
  contents_.push_back(content_hash(arrays));
  ids_.push_back(made->record.id);
  if (!last) return;
  const std::size_t changed = changed_bytes(stored_form(engine_, *last), arrays);
  changed_ += changed;
  std::size_t all = 0;
  for (const StoredArray& array : arrays.arrays) all += array.flat().size();
  changed_share_.push_back(static_cast<double>(changed) / static_cast<double>(all));
  const auto& counts = made->revision.report.counts;
  new_tets_.push_back(1 - static_cast<double>(counts.tets_kept) / static_cast<double>(counts.tets));
}

void Chain::make() {
  Store store(settings_.folder), none;
  MemoryBudget budget(kMemory), other_budget(kMemory);
  Archive archive(engine_, store, budget), memory(engine_, none, other_budget);
  HeldRevisionPtr last;
  for (int n = 0; n <= settings_.edits; ++n) {
    const HeldRevisionPtr made = next(last, n);
    file(made, archive, memory);
    if (last) memory.remove("tool1-a@" + std::to_string(n), true);
    compare(last, made);
    last = made;
  }
}

void Chain::tell_costs(std::uint64_t disk) {
  constexpr double kMega = 1e6;
  const double of_edits = static_cast<double>(disk - first_bytes_);
  goals_.tell("edits of tool1-a", settings_.edits);
  goals_.tell("tets that are new, of an edit's, at the median", median(new_tets_));
  goals_.tell("bytes that changed, of a revision's, at the median", median(changed_share_));
  goals_.tell("and at the 95th percentile", percentile(changed_share_, .95));
  goals_.tell("first revision", static_cast<double>(first_bytes_) / kMega, "MB");
  goals_.tell("an edit, at the mean", of_edits / settings_.edits / kMega, "MB");
  goals_.tell("an edit, at most", static_cast<double>(largest_edit_) / kMega, "MB");
  const double share = of_edits / settings_.edits / static_cast<double>(first_bytes_);
  if (settings_.pins)
    goals_.must_be_at_most("an edit, of a first revision", share, "", .25);
  else
    goals_.tell("an edit, of a first revision", share);
  goals_.must_be_at_most("disk over changed bytes", of_edits / static_cast<double>(changed_), "",
                         2.5);
  goals_.at_most("durable over in memory", median(durable_) - median(in_memory_), "ms", 10);
  goals_.tell("of it processor time", median(processor_), "ms");
}

void Chain::read_back(std::uint64_t disk) {
  const auto start = Clock::now();
  Store store(settings_.folder);
  goals_.tell("opening", milliseconds_since(start), "ms");
  {
    MemoryBudget budget(kMemory, kMemory / 4);
    Archive archive(engine_, store, budget);
    read_all(archive, "read back");
  }
  MemoryBudget budget(kMemory, kMemory / 4);
  Archive archive(engine_, store, budget);
  const std::uint64_t half = disk / 2;
  archive.collect_garbage({.disk_bytes = half});
  goals_.must_be_at_most(
      "disk once half of it was asked for, over that",
      static_cast<double>(bytes_below(settings_.folder / "packs")) / static_cast<double>(half), "",
      1);
  read_all(archive, "then read back or made again");
}

void Chain::read_all(Archive& archive, const std::string& what) {
  int wrong = 0, read = 0;
  double reading = 0;
  for (std::size_t n = 0; n < ids_.size(); n += static_cast<std::size_t>(settings_.read_every)) {
    const auto start = Clock::now();
    const HeldRevisionPtr held = archive.get(ids_[n], run_);
    reading += milliseconds_since(start);
    wrong += content_hash(stored_form(engine_, *held)) != contents_[n];
    ++read;
  }
  goals_.tell(what, read);
  goals_.must_be_at_most("of them wrong", wrong, "", 0);
  goals_.tell("one takes", reading / read, "ms");
}

}  // namespace
}  // namespace remeshd::test

int main(int argc, char** argv) {
  remeshd::test::Settings settings;
  remeshd::test::LoadProgram program("Costs of a chain of edits in a store", settings.goals);
  CLI::App& options = program.options();
  options.add_option("--edits", settings.edits);
  options.add_option("--nodes", settings.nodes);
  options.add_flag("--pins", settings.pins);
  options.add_option("--read-every", settings.read_every);
  options.add_option("--folder", settings.folder,
                     "on the disk to be measured; default: of temporary files");
  return program.run(argc, argv, [&] {
    const std::filesystem::path disk =
        settings.folder.empty() ? std::filesystem::temp_directory_path() : settings.folder;
    settings.folder = disk / ("remeshd-store-chain-" + std::to_string(::getpid()));
    const int result = remeshd::test::Chain(settings).run();
    std::filesystem::remove_all(settings.folder);
    return result;
  });
}
