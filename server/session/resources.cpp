#include "server/session/resources.h"

#include <utility>

#include "server/admission/process_memory.h"

namespace remeshd {
namespace {

constexpr int kMetadataThreads = 2, kPreparationThreads = 4;
constexpr std::size_t kLaneQueue = 1024;
/// Of computations: a refusal, health or a progress event does not wait for the end of a worker's
/// turn on the processor.
constexpr int kComputationNiceness = 5;

}  // namespace

Resources::Resources(Engine engine, SessionLimits limits)
    : engine_(std::move(engine)),
      limits_(std::move(limits)),
      memory_(limits_.memory, limits_.held),
      disk_(limits_.disk),
      metadata_({.workers = kMetadataThreads, .queue = kLaneQueue, .wait = limits_.wait}),
      preparation_({.workers = kPreparationThreads, .queue = kLaneQueue, .wait = limits_.wait}),
      computation_({.workers = limits_.workers,
                    .queue = limits_.queue,
                    .wait = limits_.wait,
                    .compute = limits_.compute,
                    .niceness = kComputationNiceness}),
      admission_(computation_) {
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
