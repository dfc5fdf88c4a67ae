// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/client_context.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "client/library/farm.h"
#include "client/library/routes.h"
#include "remeshd/call_options.h"

namespace remeshd::client {

/// The context of one call: who calls, its route, its deadline, and its cancellation by a stop
/// request.
class CallContext {
 public:
  CallContext(const CallOptions& options, const Replica& replica, const std::string& route) {
    if (!replica.token.empty()) context_.AddMetadata("authorization", "Bearer " + replica.token);
    context_.AddMetadata("x-remesh-key", key_of(route));
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
