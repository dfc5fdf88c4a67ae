#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>

#include "server/admission/admission.h"
#include "server/admission/freed_memory.h"
#include "server/admission/memory_budget.h"
#include "server/admission/pool.h"
#include "server/limits.h"
#include "server/observe/metrics.h"
#include "server/session/disk_budget.h"
#include "server/session/engine.h"

namespace remeshd {

struct SessionLimits {
  int workers = 1;                             ///< computations at a time
  int threads = 1;                             ///< at most, for one computation
  std::size_t queue = limits::kQueue;          ///< computations that may wait
  double wait = limits::kQueueWait;            ///< s that one may wait
  double compute = limits::kComputeTime;       ///< s that one may take; 0: any
  std::uint64_t memory = limits::kMemory;      ///< bytes of all that MemoryBudget counts
  std::uint64_t held = limits::kHeld;          ///< bytes of revisions held, at most
  std::uint64_t disk = 0;                      ///< bytes that stored meshes may take; 0: no limit
  std::uint32_t max_nodes = kDefaultMaxNodes;  ///< as Run::max_nodes
  /// Folder for the stages of computations, those of a named tenant in `tenants/NAME` below it; of
  /// each in one by its revision's id. Empty: none.
  std::filesystem::path dumps;
};

/// Where work is done.
enum class Lane {
  Metadata,     ///< answered from the catalogue alone; never waits for the disk
  Preparation,  ///< a revision may have to be read, or the catalogue's change be written
  Computation,  ///< geometry is worked on
};

/// Its name in the metrics.
const char* name_of(Lane lane);

/// What the sessions of all tenants share: the engine, the lanes, the budgets of memory and disk.
class Resources {
 public:
  /// `metrics`: null for none.
  Resources(Engine engine, SessionLimits limits, std::shared_ptr<Metrics> metrics);
  /// As `stop`.
  ~Resources();
  Resources(const Resources&) = delete;
  Resources& operator=(const Resources&) = delete;

  [[nodiscard]] const Engine& engine() const { return engine_; }
  [[nodiscard]] const SessionLimits& limits() const { return limits_; }
  MemoryBudget& memory() { return memory_; }
  DiskBudget& disk() { return disk_; }
  /// Null: nothing is counted.
  [[nodiscard]] Metrics* metrics() const { return metrics_.get(); }
  Pool& lane(Lane lane);
  /// Who is let in to the lane of computations.
  Admission& admission() { return admission_; }

  /// Refuses what waits in the lanes, and returns when what runs has ended.
  void stop();

 private:
  const Engine engine_;
  const SessionLimits limits_;
  const std::shared_ptr<Metrics> metrics_;
  MemoryBudget memory_;
  DiskBudget disk_;
  Pool metadata_;
  Pool preparation_;
  Pool computation_;
  Admission admission_;
  FreedMemory freed_memory_;
};

}  // namespace remeshd
