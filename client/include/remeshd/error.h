// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

#include "remesh/v1/remesh.pb.h"

namespace remeshd::client {

/// A call or a request of a stream that failed. `detail()` says what, where and what would help;
/// `what()` is the same in one line.
class CallError : public std::runtime_error {
 public:
  explicit CallError(remesh::v1::Error detail);
  [[nodiscard]] const remesh::v1::Error& detail() const { return detail_; }
  [[nodiscard]] remesh::v1::Error::Code code() const { return detail_.code(); }

 private:
  remesh::v1::Error detail_;
};

/// An error in one line: `feature hole1, parameter radius: message (hint)`.
std::string describe(const remesh::v1::Error& error);

}  // namespace remeshd::client
