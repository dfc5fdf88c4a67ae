#include "server/store/store_error.h"

#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

namespace remeshd::error {
namespace {

ErrorInfo store_info(ErrorKind kind, std::string reason, std::string message) {
  ErrorInfo info;
  info.kind = kind;
  info.reason = std::move(reason);
  info.message = std::move(message);
  info.stage = "store";
  return info;
}

}  // namespace

Error store_failed(std::string_view doing, std::string_view path, int error_number) {
  const bool full = error_number == ENOSPC || error_number == EDQUOT;
  ErrorInfo info = store_info(full ? ErrorKind::ResourceExhausted : ErrorKind::Internal,
                              full ? "STORE_FULL" : "STORE_FAILED",
                              "the store failed " + std::string(doing) + " " +
                                  std::filesystem::path(path).filename().string() + ": " +
                                  std::generic_category().message(error_number));
  if (full) info.hint = "free space on the store's disk, for instance by deleting revisions";
  return Error(std::move(info));
}

Error store_corrupted(std::string_view id, std::string_view what) {
  ErrorInfo info =
      store_info(ErrorKind::Internal, "STORE_CORRUPTED",
                 "the stored revision " + std::string(id) + " is damaged: " + std::string(what));
  info.hint = "sending the request that made the revision again makes it anew";
  return Error(std::move(info));
}

Error store_locked(std::string_view path) {
  ErrorInfo info = store_info(ErrorKind::FailedPrecondition, "STORE_LOCKED",
                              "the store " + std::string(path) + " is in use by another process");
  info.hint = "stop the other process, or give this one a store of its own";
  return Error(std::move(info));
}

Error store_foreign(std::string_view path, std::string_view example) {
  ErrorInfo info = store_info(
      ErrorKind::FailedPrecondition, "STORE_FOREIGN",
      std::string(path) + " is no store of remeshd, and not empty: it has " + std::string(example));
  info.hint = "give an empty folder, or one that does not exist";
  return Error(std::move(info));
}

Error store_newer(std::string_view path, int version, int known) {
  ErrorInfo info =
      store_info(ErrorKind::FailedPrecondition, "STORE_NEWER",
                 "the store " + std::string(path) + " has version " + std::to_string(version) +
                     "; this program knows those up to " + std::to_string(known));
  info.hint = "start the version of remeshd that wrote it, or a later one";
  return Error(std::move(info));
}

}  // namespace remeshd::error
