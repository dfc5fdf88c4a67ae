#include "server/session/fetcher.h"

#include <chrono>
#include <optional>
#include <utility>

#include "server/admission/load_error.h"
#include "server/session/catching.h"
#include "server/session/session_error.h"

namespace remeshd {

/// A mesh that is being made again, or waits for its turn.
struct Fetcher::Remake {
  std::string id;
  std::stop_source stop;
  WorkId work = 0;
  std::vector<WaiterPtr> waiting;  ///< guarded by the fetcher's mutex
};

/// Who waits for a mesh that is being made again.
struct Fetcher::Waiter {
  Receiver receiver;
  std::weak_ptr<Remake> remake;
  std::optional<std::stop_callback<std::function<void()>>> on_stop;
};

void Fetcher::fetch(const std::string& id, const std::stop_token& stop, const Receiver& receiver) {
  catching(
      [&] {
        const Run run{.stop = stop, .on_progress = {}, .dumps = {}};
        if (const auto revision = parts_.archive.at_hand(id, run)) {
          receiver.got(revision);
        } else {
          wait_for_remake(id, stop, receiver);
        }
      },
      receiver.failed);
}

void Fetcher::wait_for_remake(const std::string& id, const std::stop_token& stop,
                              const Receiver& receiver) {
  const auto waiter = std::make_shared<Waiter>();
  waiter->receiver = receiver;
  {
    const std::scoped_lock lock(mutex_);
    if (stopped_) throw error::shutting_down();
    RemakePtr& remake = by_id_[id];
    if (!remake) {
      try {
        const auto fresh = std::make_shared<Remake>();
        fresh->id = id;
        start(fresh);
        remake = fresh;
      } catch (...) {
        by_id_.erase(id);
        throw;
      }
    }
    remake->waiting.push_back(waiter);
    waiter->remake = remake;
  }
  // Outside of the lock: where the stop has been requested already, this calls `leave`. By a weak
  // pointer, or the waiter would hold itself.
  waiter->on_stop.emplace(stop, [this, weak = std::weak_ptr(waiter)] {
    if (const WaiterPtr leaving = weak.lock()) leave(leaving);
  });
}

/// Pre: under the mutex, so that the computation finds who waits for it.
void Fetcher::start(const RemakePtr& remake) {
  const auto failed = [this, remake](const Error& why) { fail(remake, why); };
  remake->work = parts_.computation.submit({.tenant = tenant_,
                                            .run = [this, remake] { compute(remake); },
                                            .refused = failed,
                                            .overdue =
                                                [remake, failed](const Error& why) {
                                                  remake->stop.request_stop();
                                                  failed(why);
                                                }});
}

void Fetcher::compute(const RemakePtr& remake) {
  catching(
      [&] {
        const auto start = std::chrono::steady_clock::now();
        const HeldRevisionPtr revision = parts_.archive.get(
            remake->id, Run{.stop = remake->stop.get_token(), .on_progress = {}, .dumps = {}});
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
        parts_.computation.took(spent.count());
        for (const WaiterPtr& waiter : remove(remake)) hand_over(waiter->receiver, revision);
      },
      [&](const Error& why) { fail(remake, why); });
}

void Fetcher::hand_over(const Receiver& receiver, const HeldRevisionPtr& revision) {
  catching(
      [&] {
        parts_.preparation.submit(
            {.tenant = tenant_,
             .run = [receiver,
                     revision] { catching([&] { receiver.got(revision); }, receiver.failed); },
             .refused = receiver.failed});
      },
      receiver.failed);
}

void Fetcher::fail(const RemakePtr& remake, const Error& why) {
  for (const WaiterPtr& waiter : remove(remake)) contained([&] { waiter->receiver.failed(why); });
}

std::vector<Fetcher::WaiterPtr> Fetcher::remove(const RemakePtr& remake) {
  const std::scoped_lock lock(mutex_);
  const auto entry = by_id_.find(remake->id);
  if (entry != by_id_.end() && entry->second == remake) by_id_.erase(entry);
  return std::exchange(remake->waiting, {});
}

void Fetcher::leave(const WaiterPtr& waiter) {
  {
    const std::scoped_lock lock(mutex_);
    const RemakePtr remake = waiter->remake.lock();
    if (!remake || std::erase(remake->waiting, waiter) == 0) return;  // it has its answer
    if (remake->waiting.empty()) {
      remake->stop.request_stop();
      parts_.computation.withdraw(remake->work);
      by_id_.erase(remake->id);
    }
  }
  contained([&] { waiter->receiver.failed(error::cancelled()); });
}

void Fetcher::stop() {
  std::map<std::string, RemakePtr> all;
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
    all = by_id_;
  }
  for (const auto& [id, remake] : all) {
    remake->stop.request_stop();
    fail(remake, error::shutting_down());
  }
}

std::size_t Fetcher::waiting() const {
  const std::scoped_lock lock(mutex_);
  std::size_t waiting = 0;
  for (const auto& [id, remake] : by_id_) waiting += remake->waiting.size();
  return waiting;
}

}  // namespace remeshd
