// SPDX-License-Identifier: Apache-2.0
#include "client/library/farm.h"

#include <algorithm>
#include <utility>

namespace remeshd::client {
namespace {

constexpr std::size_t kMostRoutes = 10'000;

}  // namespace

Replica::Replica(std::string its_address, std::shared_ptr<grpc::Channel> channel,
                 std::string token_to_send)
    : address(std::move(its_address)),
      token(std::move(token_to_send)),
      channel_(std::move(channel)),
      service_(Service::NewStub(channel_)),
      cache_(Cache::NewStub(channel_)) {}

bool Replica::connects(std::chrono::milliseconds time) const {
  const auto end = std::chrono::system_clock::now() + time;
  while (true) {
    const grpc_connectivity_state state = channel_->GetState(true);
    if (state == GRPC_CHANNEL_READY) return true;
    if (state == GRPC_CHANNEL_TRANSIENT_FAILURE || state == GRPC_CHANNEL_SHUTDOWN) return false;
    if (!channel_->WaitForStateChange(state, end)) return false;
  }
}

bool Farm::reached() const {
  return std::ranges::any_of(replicas_,
                             [](const auto& replica) { return replica->reached.load(); });
}

Replica* Farm::at(const std::string& address) const {
  const auto found = std::ranges::find(
      replicas_, address, [](const auto& replica) -> const auto& { return replica->address; });
  return found == replicas_.end() ? nullptr : found->get();
}

Replica* Farm::home_of(const std::string& route) const {
  const std::lock_guard lock(mutex_);
  const auto found = homes_.find(route);
  return found == homes_.end() ? nullptr : found->second;
}

void Farm::remember_home(const std::string& route, Replica& home) {
  const std::lock_guard lock(mutex_);
  homes_[route] = &home;
}

std::optional<std::string> Farm::route_of(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = routes_.find(id);
  if (found == routes_.end()) return std::nullopt;
  return found->second;
}

void Farm::remember_route(const std::string& id, const std::string& route) {
  const std::lock_guard lock(mutex_);
  if (!routes_.try_emplace(id, route).second) return;
  remembered_.push_back(id);
  if (remembered_.size() <= kMostRoutes) return;
  routes_.erase(remembered_.front());
  remembered_.pop_front();
}

}  // namespace remeshd::client
