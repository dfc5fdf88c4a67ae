// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

#include "remesh/v1/remesh.pb.h"

namespace remeshd::client {

/// A call or a request of a stream that failed. `detail()` says what, where and what would help:
/// code, reason, features, parameter, point, line and column of a document; `what()` is the same in
/// one line.
class CallError : public std::runtime_error {
 public:
  explicit CallError(remesh::v1::Error detail);
  [[nodiscard]] const remesh::v1::Error& detail() const { return detail_; }
  [[nodiscard]] remesh::v1::Error::Code code() const { return detail_.code(); }
  [[nodiscard]] remesh::v1::Error::Reason reason() const { return detail_.reason(); }

 private:
  remesh::v1::Error detail_;
};

/// An error in one line: `feature hole1, parameter radius: message (hint)`. What the message says
/// itself is not said again.
std::string describe(const remesh::v1::Error& error);

/// `BOUNDARY_NOT_RECOVERED`; where an error has no reason, or one that this library does not know,
/// the name of its code: `UNAVAILABLE`.
std::string reason_name(const remesh::v1::Error& error);

/// `INVALID_ARGUMENT`, as gRPC spells it.
std::string code_name(remesh::v1::Error::Code code);

}  // namespace remeshd::client
