#include "server/store/store_error.h"

#include <cerrno>
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
                              full ? "StoreFull" : "StoreFailed",
                              "the store failed " + std::string(doing) + " " + std::string(path) +
                                  ": " + std::generic_category().message(error_number));
  if (full) info.hint = "free space on the store's disk, for instance by deleting revisions";
  return Error(std::move(info));
}

Error store_corrupted(std::string_view path, std::string_view what) {
  ErrorInfo info =
      store_info(ErrorKind::Internal, "StoreCorrupted",
                 "the stored file " + std::string(path) + " is damaged: " + std::string(what));
  info.hint = "sending the request that made the revision again makes it anew";
  return Error(std::move(info));
}

Error store_locked(std::string_view path) {
  ErrorInfo info = store_info(ErrorKind::FailedPrecondition, "StoreLocked",
                              "the store " + std::string(path) + " is in use by another process");
  info.hint = "stop the other process, or give this one a store of its own";
  return Error(std::move(info));
}

}  // namespace remeshd::error
