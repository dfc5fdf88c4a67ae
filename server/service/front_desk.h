#pragma once

#include <spdlog/logger.h>

#include <atomic>
#include <cstdint>
#include <memory>

#include "server/guard/doorman.h"
#include "server/observe/metrics.h"
#include "server/service/call_gate.h"

namespace remeshd {

/// What every call passes on its way in and out. The calls share it.
struct FrontDesk {
  std::shared_ptr<spdlog::logger> log;  ///< may be null
  std::shared_ptr<Metrics> metrics;     ///< may be null
  std::shared_ptr<Doorman> doorman;     ///< null: everybody is let in
  std::shared_ptr<CallGate> gate = std::make_shared<CallGate>();
  /// Streams that are open now.
  std::shared_ptr<std::atomic<std::uint32_t>> streams =
      std::make_shared<std::atomic<std::uint32_t>>(0);
};
using FrontDeskPtr = std::shared_ptr<const FrontDesk>;

}  // namespace remeshd
