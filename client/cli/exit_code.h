#pragma once

#include <stdexcept>
#include <string>

#include "engine/base/error.h"
#include "proto/document_error.h"
#include "remeshd/error.h"

namespace remeshd::cli {

/// Exit codes of `remesh`, which callers may rely on.
enum ExitCode : int {
  kFine = 0,
  kFault = 1,  ///< what nobody expected: a fault of `remesh` itself
  kUsage = 2,
  kInvalid = 3,  ///< model, edit or name: wrong, empty, disconnected, over-sized, unknown
  kFailed = 4,   ///< meshing failed, or a deadline passed
  kUnreachable = 5,
  kBusy = 6,
  kDenied = 7,
  kFileFailed = 8,  ///< a file or stream that cannot be read or written
  kInterrupted = 130,
};

/// A command line that says something impossible.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An interrupt that came between two calls.
class Interrupted : public std::exception {};

/// The exit code that an error of the daemon calls for.
ExitCode exit_code(const remesh::v1::Error& error);

/// An error found on this side, before a call, in the words of the protocol.
remesh::v1::Error to_detail(const ErrorInfo& info);
remesh::v1::Error to_detail(const DocumentErrorInfo& info);

}  // namespace remeshd::cli
