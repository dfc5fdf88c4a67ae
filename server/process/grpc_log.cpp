#include "server/process/grpc_log.h"

#include <grpc/support/log.h>

#include <mutex>
#include <utility>

namespace remeshd {
namespace {

// gRPC's hook is a plain function, called from threads that may outlive all static objects: so the
// target is global and never destroyed.
struct Target {
  std::mutex mutex;
  std::shared_ptr<spdlog::logger> log;
};
Target& target() {
  static auto* const the_only_one = new Target;
  return *the_only_one;
}

void write(gpr_log_func_args* line) {
  std::shared_ptr<spdlog::logger> log;
  {
    const std::scoped_lock lock(target().mutex);
    log = target().log;
  }
  if (log) log->warn("gRPC: {}", line->message);
}

}  // namespace

void redirect_grpc_log(std::shared_ptr<spdlog::logger> log) {
  {
    const std::scoped_lock lock(target().mutex);
    target().log = std::move(log);
  }
  gpr_set_log_function(write);
}

}  // namespace remeshd
