// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/client_context.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "remeshd/call_options.h"

namespace remeshd::client {

/// The context of one call: who calls, its deadline, and its cancellation by a stop request.
class CallContext {
 public:
  /// `token`: as ConnectOptions has it.
  CallContext(const CallOptions& options, const std::string& token) {
    if (!token.empty()) context_.AddMetadata("authorization", "Bearer " + token);
    if (options.timeout)
      context_.set_deadline(std::chrono::system_clock::now() +
                            std::chrono::microseconds(std::llround(*options.timeout * 1e6)));
    if (options.stop.stop_possible()) on_stop_.emplace(options.stop, [this] { cancel(); });
  }
  grpc::ClientContext* get() { return &context_; }
  void cancel() { context_.TryCancel(); }

 private:
  grpc::ClientContext context_;
  std::optional<std::stop_callback<std::function<void()>>> on_stop_;
};

}  // namespace remeshd::client
