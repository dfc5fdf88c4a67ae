// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/support/status.h>

#include <atomic>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "remesh/v1/cache.grpc.pb.h"
#include "remesh/v1/remesh.grpc.pb.h"

namespace remeshd::client {

/// One daemon: the way to it, and whether it answers.
class Replica {
 public:
  using Clock = std::chrono::steady_clock;
  using Service = remesh::v1::RemeshService;
  using Cache = remesh::v1::CacheService;

  /// `token`: as ConnectOptions has it.
  Replica(std::string address, std::shared_ptr<grpc::Channel> channel, std::string token);

  /// The stub that has the method.
  Service::Stub& of(const Service::Stub* /*service*/) const { return *service_; }
  Cache::Stub& of(const Cache::Stub* /*service*/) const { return *cache_; }
  Service::Stub& service() const { return *service_; }
  Cache::Stub& cache() const { return *cache_; }
  /// Whether there is a connection to it; connects where there is none, within `time`.
  [[nodiscard]] bool connects(std::chrono::milliseconds time) const;
  /// Whether there is a connection now, to it or to a balancer before it.
  [[nodiscard]] bool connected() const { return channel_->GetState(false) == GRPC_CHANNEL_READY; }

  const std::string address;
  const std::string token;
  std::atomic<bool> reached = false;            ///< it has answered
  std::atomic<Clock::time_point> away_until{};  ///< until then it is passed over

 private:
  const std::shared_ptr<grpc::Channel> channel_;
  const std::unique_ptr<Service::Stub> service_;
  const std::unique_ptr<Cache::Stub> cache_;
};

/// The daemons that a client may ask: one, or the replicas of a farm that share a tier. May be used
/// from any thread.
class Farm {
 public:
  /// Pre: one replica at least.
  explicit Farm(std::vector<std::unique_ptr<Replica>> replicas) : replicas_(std::move(replicas)) {}

  [[nodiscard]] const std::vector<std::unique_ptr<Replica>>& replicas() const { return replicas_; }
  [[nodiscard]] bool several() const { return replicas_.size() > 1; }
  /// Whether any has ever answered. Where none did, the addresses may be wrong.
  [[nodiscard]] bool reached() const;
  /// Null where no replica has the address.
  [[nodiscard]] Replica* at(const std::string& address) const;

  /// The home of the design that a route stands for, where a replica has told it
  /// (DESIGN_ELSEWHERE); else null.
  [[nodiscard]] Replica* home_of(const std::string& route) const;
  void remember_home(const std::string& route, Replica& home);
  /// The route of a revision that this client made or looked up, by its id.
  [[nodiscard]] std::optional<std::string> route_of(const std::string& id) const;
  void remember_route(const std::string& id, const std::string& route);

 private:
  const std::vector<std::unique_ptr<Replica>> replicas_;
  mutable std::mutex mutex_;  ///< guards what follows
  std::map<std::string, Replica*> homes_;
  std::map<std::string, std::string> routes_;
  std::deque<std::string> remembered_;  ///< ids in `routes_`, the oldest first
};

}  // namespace remeshd::client
