#include "server/store/store_error.h"

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

namespace remeshd::error {
Error store_failed(std::string_view doing, std::string_view path, int error_number) {
  const bool full = error_number == ENOSPC || error_number == EDQUOT;
  return Error(
      {.kind = full ? ErrorKind::ResourceExhausted : ErrorKind::Internal,
       .reason = full ? "STORE_FULL" : "STORE_FAILED",
       .message = "the store failed " + std::string(doing) + " " +
                  std::filesystem::path(path).filename().string() + ": " +
                  std::generic_category().message(error_number),
       .stage = "store",
       .hint = full ? "free space on the store's disk, for instance by deleting revisions" : ""});
}

Error store_corrupted(std::string_view id, std::string_view what) {
  return Error(
      {.kind = ErrorKind::Internal,
       .reason = "STORE_CORRUPTED",
       .message = "the stored revision " + std::string(id) + " is damaged: " + std::string(what),
       .stage = "store",
       .hint = "sending the request that made the revision again makes it anew"});
}

Error store_locked(std::string_view path) {
  return Error({.kind = ErrorKind::FailedPrecondition,
                .reason = "STORE_LOCKED",
                .message = "the store " + std::string(path) + " is in use by another process",
                .stage = "store",
                .hint = "stop the other process, or give this one a store of its own"});
}

Error store_foreign(std::string_view path, std::string_view example) {
  return Error({.kind = ErrorKind::FailedPrecondition,
                .reason = "STORE_FOREIGN",
                .message = std::string(path) + " is no store of remeshd, and not empty: it has " +
                           std::string(example),
                .stage = "store",
                .hint = "give an empty folder, or one that does not exist"});
}

Error store_newer(std::string_view path, int version, int known) {
  return Error({.kind = ErrorKind::FailedPrecondition,
                .reason = "STORE_NEWER",
                .message = "the store " + std::string(path) + " has version " +
                           std::to_string(version) + "; this program knows those up to " +
                           std::to_string(known),
                .stage = "store",
                .hint = "start the version of remeshd that wrote it, or a later one"});
}

}  // namespace remeshd::error
