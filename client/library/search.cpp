// SPDX-License-Identifier: Apache-2.0
#include "client/library/search.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string_view>
#include <utility>

#include "client/library/status.h"
#include "proto/rendezvous.h"

namespace remeshd::client {
namespace {

using remesh::v1::Error;
using Seconds = std::chrono::duration<double>;

/// ms for which one of several replicas that did not answer is passed over, and ms between tries of
/// a single daemon.
constexpr std::chrono::milliseconds kAway(1000), kBetweenTries(200);

/// What gRPC says of calls that a balancer in between reset, cut, or answered itself.
constexpr std::array<std::string_view, 3> kCut{"RST_STREAM", "Stream removed",
                                               "http2 header with status: 5"};

Replica::Clock::duration duration(double seconds) {
  return std::chrono::duration_cast<Replica::Clock::duration>(Seconds(seconds));
}

/// Sleeps; false where it was woken.
bool sleep(Replica::Clock::duration time, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  never.wait_for(lock, stop, time, [] { return false; });
  return !stop.stop_requested();
}

bool is_away(const Replica* replica) { return replica->away_until.load() > Replica::Clock::now(); }

/// gRPC's own errors have no reason; a broken stream gets one here.
bool has_reason(const Error& error) {
  return error.reason() != Error::REASON_UNSPECIFIED && error.reason() != Error::STREAM_ENDED;
}

}  // namespace

bool is_broken(const grpc::Status& status) {
  switch (status.error_code()) {
    case grpc::StatusCode::UNAVAILABLE:
    case grpc::StatusCode::CANCELLED:  // a daemon that ends cancels its calls
      return true;
    case grpc::StatusCode::INTERNAL:
    case grpc::StatusCode::UNKNOWN:
      return std::ranges::any_of(kCut, [&](std::string_view cut) {
        return status.error_message().find(cut) != std::string::npos;
      });
    default:
      return false;
  }
}

Search::Search(std::shared_ptr<Farm> farm, std::string route, const CallOptions& options)
    : farm_(std::move(farm)), route_(std::move(route)), options_(options) {
  rank();
}

void Search::rank() {
  std::vector<std::string> addresses;
  for (const auto& replica : farm_->replicas()) addresses.push_back(replica->address);
  ranked_.clear();
  for (const std::size_t index : rank_by_rendezvous(addresses, route_))
    ranked_.push_back(farm_->replicas()[index].get());
  if (Replica* home = farm_->home_of(route_))
    std::ranges::stable_partition(ranked_, [&](const Replica* each) { return each == home; });
}

Replica& Search::replica() const {
  const auto here = std::ranges::find_if_not(ranked_, is_away);
  if (here != ranked_.end()) return **here;
  return **std::ranges::min_element(ranked_, {},
                                    [](const Replica* each) { return each->away_until.load(); });
}

CallOptions Search::rest() const {
  CallOptions rest = options_;
  if (rest.timeout) *rest.timeout -= Seconds(Clock::now() - begun_).count();
  return rest;
}

void Search::heard(Replica& replica) {
  replica.reached = true;
  if (!failed_since_) return;
  failed_since_.reset();
  sent_home_ = false;
  rank();
}

bool Search::goes_on(Replica& failed, const grpc::Status& status) {
  return goes_on(failed, error_of(status), is_broken(status));
}

bool Search::goes_on(Replica& failed, const Error& error) { return goes_on(failed, error, false); }

bool Search::goes_on(Replica& failed, const Error& error, bool broken) {
  if (options_.stop.stop_requested() || stop_.stop_requested()) return false;
  if (!failed_since_) failed_since_ = Clock::now();
  // Something answered at this address: the daemon, or a balancer.
  if (!broken || error.code() != Error::CODE_UNAVAILABLE || has_reason(error) || failed.connected())
    failed.reached = true;
  if (error.reason() == Error::DESIGN_ELSEWHERE) return goes_home(error.home());
  // A revision that one does not know another one may have, which has not yet written it to the
  // tier.
  if (error.reason() == Error::REVISION_NOT_FOUND && ranked_.size() > 1) {
    std::erase(ranked_, &failed);
  } else if (broken || (farm_->several() && error.code() == Error::CODE_UNAVAILABLE)) {
    const auto pause = farm_->several() ? kAway : kBetweenTries;
    failed.away_until =
        Clock::now() + (error.has_retry_after() ? duration(error.retry_after()) : pause);
  } else {
    return false;
  }
  return waits();
}

/// Asks the home of the design alone from now on. False where no replica has the address, or where
/// a home was followed before.
bool Search::goes_home(const std::string& address) {
  Replica* home = farm_->at(address);
  if (home == nullptr || sent_home_) return false;
  sent_home_ = true;
  farm_->remember_home(route_, *home);
  ranked_ = {home};
  return true;
}

/// Waits until a replica may be asked; false where that is not to be waited for.
bool Search::waits() {
  const auto away_until = replica().away_until.load();
  const auto now = Clock::now();
  if (away_until <= now) return true;
  if (!farm_->reached() || away_until - *failed_since_ > duration(options_.reconnect)) return false;
  if (options_.timeout && away_until - begun_ > duration(*options_.timeout)) return false;
  // A stop request of the caller's ends the wait too.
  const std::stop_callback<std::function<void()>> stopped(options_.stop, [this] { stop(); });
  return sleep(away_until - now, stop_.get_token());
}

}  // namespace remeshd::client
