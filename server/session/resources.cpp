#include "server/session/resources.h"

#include <functional>
#include <string>
#include <utility>

#include "server/admission/process_memory.h"
#include "server/limits.h"

namespace remeshd {
namespace {

/// Counts how long work waits for a lane.
std::function<void(double)> counts_waits(Lane lane, Metrics* metrics) {
  if (metrics == nullptr) return {};
  return [metrics, name = std::string(name_of(lane))](double seconds) {
    metrics->queue_waited(name, seconds);
  };
}

}  // namespace

const char* name_of(Lane lane) {
  static constexpr const char* kNames[] = {"metadata", "preparation", "computation"};
  return kNames[static_cast<std::size_t>(lane)];
}

Resources::Resources(Engine engine, SessionLimits limits, std::shared_ptr<Metrics> metrics)
    : engine_(std::move(engine)),
      limits_(std::move(limits)),
      metrics_(std::move(metrics)),
      memory_(limits_.memory, limits_.held),
      disk_(limits_.disk),
      metadata_({.workers = limits::kMetadataThreads,
                 .queue = limits::kLaneQueue,
                 .wait = limits_.wait,
                 .waited = counts_waits(Lane::Metadata, metrics_.get())}),
      preparation_({.workers = limits::kPreparationThreads,
                    .queue = limits::kLaneQueue,
                    .wait = limits_.wait,
                    .waited = counts_waits(Lane::Preparation, metrics_.get())}),
      computation_({.workers = limits_.workers,
                    .queue = limits_.queue,
                    .wait = limits_.wait,
                    .compute = limits_.compute,
                    .niceness = limits::kComputationNiceness,
                    .waited = counts_waits(Lane::Computation, metrics_.get())}),
      admission_(computation_),
      // A reader that ends may free a revision without telling the budget.
      freed_memory_({resident_bytes, return_freed_memory}, [this] { memory_.trim(); }) {
  memory_.set_process({resident_bytes, return_freed_memory});
}

Resources::~Resources() { stop(); }

Pool& Resources::lane(Lane lane) {
  switch (lane) {
    case Lane::Metadata:
      return metadata_;
    case Lane::Preparation:
      return preparation_;
    case Lane::Computation:
      break;
  }
  return computation_;
}

void Resources::stop() {
  metadata_.shutdown();
  preparation_.shutdown();
  computation_.shutdown();
}

}  // namespace remeshd
