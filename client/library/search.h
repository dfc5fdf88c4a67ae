// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/support/status.h>

#include <chrono>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "client/library/farm.h"
#include "remesh/v1/error.pb.h"
#include "remeshd/call_options.h"

namespace remeshd::client {

/// Which daemon a request goes to, and where it goes when that one fails.
///
/// All requests of a loop have one route, and go to the replica that ranks first for this route by
/// rendezvous hashing: that replica has the base in memory. If it does not answer, the next in rank
/// takes over, and gets the revisions that it lacks from the tier. Requests name revisions by id,
/// so nothing is done twice. A single daemon is a list of one. The Python client ranks in the same
/// way.
///
/// For one thread, but for `stop`, which any thread may call.
class Search {
 public:
  Search(std::shared_ptr<Farm> farm, std::string route, const CallOptions& options);

  [[nodiscard]] const std::string& route() const { return route_; }
  /// The replica to ask now.
  [[nodiscard]] Replica& replica() const;
  /// The options for a call from now on: what is left of the time.
  [[nodiscard]] CallOptions rest() const;
  /// To be called when something new came from a replica: the time for which calls are tried again
  /// begins anew with the next failure, and all replicas are ranked again.
  void heard(Replica& replica);
  /// Whether `replica()` is to be asked after a call to `failed` ended with `status`; waits while
  /// all are away. False for an error that another one would give too; after a stop request; where
  /// all are away until after `reconnect` seconds from the first failure, or until after the
  /// timeout of the call; where none ever answered, for the addresses may be wrong.
  [[nodiscard]] bool goes_on(Replica& failed, const grpc::Status& status);
  /// The same for an error with which the replica answered a request of a stream.
  [[nodiscard]] bool goes_on(Replica& failed, const remesh::v1::Error& error);
  /// Ends the waiting, and tries no more. May be called from another thread.
  void stop() { stop_.request_stop(); }

 private:
  using Clock = Replica::Clock;

  [[nodiscard]] bool goes_on(Replica& failed, const remesh::v1::Error& error, bool broken);
  [[nodiscard]] bool goes_home(const std::string& address);
  [[nodiscard]] bool waits();
  void rank();

  const std::shared_ptr<Farm> farm_;
  const std::string route_;
  const CallOptions options_;
  const Clock::time_point begun_ = Clock::now();
  std::vector<Replica*> ranked_;  ///< those that may be asked, the first foremost
  bool sent_home_ = false;
  std::optional<Clock::time_point> failed_since_;
  std::stop_source stop_;
};

/// Whether the connection broke, so that nobody knows whether the request was done: the daemon is
/// gone, or ended, or a balancer in between cut the call. Also true for UNAVAILABLE from a daemon
/// itself, which then gives a reason and has not done it.
bool is_broken(const grpc::Status& status);

}  // namespace remeshd::client
