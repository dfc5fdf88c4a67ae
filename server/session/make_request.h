#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "server/admission/contained.h"
#include "server/session/commands.h"

namespace remeshd {

/// A command under way, as its caller sees it.
class MakeRequest {
 public:
  virtual ~MakeRequest() = default;
  /// Answers the request with Cancelled at once, unless it is answered already. The computation
  /// stops if nobody else waits for it.
  virtual void cancel() = 0;
};
using MakeRequestPtr = std::shared_ptr<MakeRequest>;

struct Computation;

/// The same as the scheduler sees it.
class WaitingRequest final : public MakeRequest,
                             public std::enable_shared_from_this<WaitingRequest> {
 public:
  using Cancel = std::function<void(const std::shared_ptr<WaitingRequest>&)>;

  WaitingRequest(std::string tenant, Listener listener, Cancel cancel)
      : tenant_(std::move(tenant)), listener_(std::move(listener)), cancel_(std::move(cancel)) {}

  void cancel() override { cancel_(shared_from_this()); }

  /// Marks the request as answered; false if it was already.
  bool close() { return !answered_.exchange(true); }
  [[nodiscard]] bool answered() const { return answered_; }
  /// Tells of progress, unless it is answered.
  void report(const Progress& progress) const {
    if (!answered_ && listener_.progress) contained([&] { listener_.progress(progress); });
  }

  [[nodiscard]] const std::string& tenant() const { return tenant_; }
  [[nodiscard]] const Listener& listener() const { return listener_; }
  /// Stops its preparation.
  [[nodiscard]] std::stop_source& stop() { return stop_; }

  // Once it is prepared: how its revision is to be filed.
  std::string design;
  HeadRule head;
  std::vector<WarningCode> fail_on;

  /// The computation that it waits for; guarded by the computations' mutex.
  std::weak_ptr<Computation> joined;

 private:
  const std::string tenant_;
  const Listener listener_;
  const Cancel cancel_;
  std::stop_source stop_;
  std::atomic<bool> answered_ = false;
};
using WaitingRequestPtr = std::shared_ptr<WaitingRequest>;

}  // namespace remeshd
