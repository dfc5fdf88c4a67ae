// SPDX-License-Identifier: Apache-2.0
#include "client/library/reconnecting.h"

#include <condition_variable>
#include <functional>
#include <mutex>

namespace remeshd::client {
namespace {

constexpr std::chrono::milliseconds kBetweenTries(200);

/// A daemon that ends cancels its calls.
bool is_broken(const grpc::Status& status) {
  return status.error_code() == grpc::StatusCode::UNAVAILABLE ||
         status.error_code() == grpc::StatusCode::CANCELLED;
}

/// Sleeps; false where it was woken.
bool sleep(std::chrono::milliseconds time, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  never.wait_for(lock, stop, time, [] { return false; });
  return !stop.stop_requested();
}

}  // namespace

CallOptions Reconnecting::rest() const {
  CallOptions rest = options_;
  if (rest.timeout) *rest.timeout -= std::chrono::duration<double>(Clock::now() - begun_).count();
  return rest;
}

void Reconnecting::heard() {
  *answered_ = true;
  broken_since_.reset();
}

bool Reconnecting::tries_again(const grpc::Status& status) {
  if (!is_broken(status) || !*answered_ || options_.reconnect <= 0) return false;
  const auto now = Clock::now();
  if (!broken_since_) broken_since_ = now;
  if (now - *broken_since_ > std::chrono::duration<double>(options_.reconnect)) return false;
  // A stop request of the caller's ends the wait too.
  const std::stop_callback<std::function<void()>> stopped(options_.stop, [this] { stop(); });
  return sleep(kBetweenTries, stop_.get_token());
}

}  // namespace remeshd::client
