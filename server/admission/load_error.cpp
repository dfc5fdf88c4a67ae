#include "server/admission/load_error.h"

#include <string>

namespace remeshd::error {
namespace {

std::string mebibytes(std::uint64_t bytes) { return std::to_string(bytes >> 20U) + " MiB"; }

}  // namespace

Error busy(std::size_t waiting, double retry_after) {
  return Error(
      {.kind = ErrorKind::ResourceExhausted,
       .reason = "BUSY",
       .message = "the daemon is busy: " + std::to_string(waiting) + " requests are waiting",
       .stage = "request",
       .hint = "try again later",
       .retry_after = retry_after});
}

Error waited_too_long(double seconds, double retry_after) {
  return Error({.kind = ErrorKind::ResourceExhausted,
                .reason = "WAITED_TOO_LONG",
                .message = "the request waited " + std::to_string(static_cast<long>(seconds)) +
                           " s for a worker",
                .stage = "request",
                .hint = "try again later",
                .retry_after = retry_after});
}

Error compute_limit_reached(double seconds) {
  return Error(
      {.kind = ErrorKind::DeadlineExceeded,
       .reason = "COMPUTE_LIMIT_REACHED",
       .message = "it computed for longer than the " + std::to_string(static_cast<long>(seconds)) +
                  " s that one request may",
       .stage = "request",
       .hint = "ask for fewer nodes or a simpler model, or start remeshd with a larger limit"});
}

Error memory_full(std::uint64_t used, std::uint64_t budget, double retry_after) {
  return Error(
      {.kind = ErrorKind::ResourceExhausted,
       .reason = "MEMORY_FULL",
       .message = mebibytes(used) + " of the " + mebibytes(budget) + " of memory are in use",
       .stage = "request",
       .hint = "delete revisions, or start remeshd with a --store or more memory",
       .retry_after = retry_after});
}

Error never_fits(std::uint64_t bytes, std::uint64_t budget) {
  return Error({.kind = ErrorKind::InvalidArgument,
                .reason = "MESH_TOO_LARGE",
                .message = "the request needs about " + mebibytes(bytes) +
                           " of memory, and the daemon has " + mebibytes(budget),
                .stage = "request",
                .hint = "ask for fewer nodes, or start remeshd with more memory"});
}

Error out_of_memory() {
  return Error({.kind = ErrorKind::ResourceExhausted,
                .reason = "OUT_OF_MEMORY",
                .message = "there is not enough memory for this request",
                .stage = "request",
                .hint = "ask for fewer nodes"});
}

Error shutting_down() {
  return Error({.kind = ErrorKind::Unavailable,
                .reason = "SHUTTING_DOWN",
                .message = "the daemon is shutting down",
                .stage = "request",
                .retry_after = 1});  // s; by then it may have been restarted or replaced
}

}  // namespace remeshd::error
