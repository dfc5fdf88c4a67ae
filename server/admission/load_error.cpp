#include "server/admission/load_error.h"

#include <string>
#include <utility>

namespace remeshd::error {
namespace {

ErrorInfo request_info(ErrorKind kind, std::string reason, std::string message) {
  ErrorInfo info;
  info.kind = kind;
  info.reason = std::move(reason);
  info.message = std::move(message);
  info.stage = "request";
  return info;
}

std::string mebibytes(std::uint64_t bytes) { return std::to_string(bytes >> 20U) + " MiB"; }

}  // namespace

Error busy(std::size_t waiting, double retry_after) {
  ErrorInfo info =
      request_info(ErrorKind::ResourceExhausted, "BUSY",
                   "the daemon is busy: " + std::to_string(waiting) + " requests are waiting");
  info.retry_after = retry_after;
  info.hint = "try again later";
  return Error(std::move(info));
}

Error waited_too_long(double seconds, double retry_after) {
  ErrorInfo info = request_info(
      ErrorKind::ResourceExhausted, "WAITED_TOO_LONG",
      "the request waited " + std::to_string(static_cast<long>(seconds)) + " s for a worker");
  info.retry_after = retry_after;
  info.hint = "try again later";
  return Error(std::move(info));
}

Error compute_limit_reached(double seconds) {
  ErrorInfo info =
      request_info(ErrorKind::DeadlineExceeded, "COMPUTE_LIMIT_REACHED",
                   "it computed for longer than the " + std::to_string(static_cast<long>(seconds)) +
                       " s that one request may");
  info.hint = "ask for fewer nodes or a simpler model, or start remeshd with a larger limit";
  return Error(std::move(info));
}

Error memory_full(std::uint64_t used, std::uint64_t budget, double retry_after) {
  ErrorInfo info =
      request_info(ErrorKind::ResourceExhausted, "MEMORY_FULL",
                   mebibytes(used) + " of the " + mebibytes(budget) + " of memory are in use");
  info.retry_after = retry_after;
  info.hint = "delete revisions, or start remeshd with a --store or more memory";
  return Error(std::move(info));
}

Error never_fits(std::uint64_t bytes, std::uint64_t budget) {
  ErrorInfo info = request_info(ErrorKind::InvalidArgument, "MESH_TOO_LARGE",
                                "the request needs about " + mebibytes(bytes) +
                                    " of memory, and the daemon has " + mebibytes(budget));
  info.hint = "ask for fewer nodes, or start remeshd with more memory";
  return Error(std::move(info));
}

Error out_of_memory() {
  ErrorInfo info = request_info(ErrorKind::ResourceExhausted, "OUT_OF_MEMORY",
                                "there is not enough memory for this request");
  info.hint = "ask for fewer nodes";
  return Error(std::move(info));
}

Error shutting_down() {
  return Error(
      request_info(ErrorKind::Unavailable, "SHUTTING_DOWN", "the daemon is shutting down"));
}

}  // namespace remeshd::error
