#include "tests/service/edit_load.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "tests/service/timing.h"

namespace remeshd::test {
namespace {

struct Call {
  grpc::ClientContext context;
  v1::EditRevisionRequest request;
  v1::EditRevisionResponse reply;
  Clock::time_point sent;
};

void count(const grpc::Status& status, const Call& call, double milliseconds,
           EditLoad::Counts& counts) {
  if (status.ok()) {
    ++counts.done;
    return;
  }
  bool retry = false;
  const std::string reason = reason_of(status, &retry);
  if (status.error_code() != grpc::StatusCode::RESOURCE_EXHAUSTED || reason != "BUSY") {
    ++counts.lost;
    ++counts.other_ends[reason + " " + status.error_message()];
    return;
  }
  ++counts.refused;
  counts.refusal_ms.push_back(milliseconds);
  const auto& metadata = call.context.GetServerTrailingMetadata();
  if (!retry || !metadata.contains("grpc-retry-pushback-ms")) ++counts.without_delay;
}

}  // namespace

EditLoad::Counts EditLoad::closed_loop(int clients, double seconds) {
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> failed = false;
  const auto start = Clock::now();
  std::vector<std::jthread> threads;
  for (int i = 0; i < clients; ++i)
    threads.emplace_back([&] {
      while (seconds_since(start) < seconds && !failed) {
        Call call;
        call.request = next();
        if (!stub_.EditRevision(&call.context, call.request, &call.reply).ok()) failed = true;
        ++done;
      }
    });
  threads.clear();
  if (failed) throw std::runtime_error("an edit failed while the daemon was not flooded");
  Counts counts;
  counts.sent = counts.done = done;
  counts.done_per_second = static_cast<double>(done) / seconds_since(start);
  return counts;
}

EditLoad::Counts EditLoad::open_loop(double per_second, double seconds) {
  std::mutex mutex;
  std::condition_variable answered;
  Counts counts;
  std::size_t open = 0;
  const auto start = Clock::now();
  const auto end = start + duration_of(seconds);
  for (auto when = start; when < end; when += duration_of(1 / per_second)) {
    std::this_thread::sleep_until(when);
    const auto call = std::make_shared<Call>();
    call->request = next();
    // A connection that is not there is no refusal.
    call->context.set_wait_for_ready(true);
    call->sent = Clock::now();
    {
      const std::scoped_lock lock(mutex);
      ++open;
      ++counts.sent;
    }
    stub_.async()->EditRevision(&call->context, &call->request, &call->reply,
                                [&, call](const grpc::Status& status) {
                                  const double spent = 1000 * seconds_since(call->sent);
                                  const std::scoped_lock lock(mutex);
                                  count(status, *call, spent, counts);
                                  --open;
                                  answered.notify_one();
                                });
  }
  std::unique_lock lock(mutex);
  answered.wait(lock, [&] { return open == 0; });
  // The worker was busy until the last answer, since requests waited.
  counts.done_per_second = static_cast<double>(counts.done) / seconds_since(start);
  return counts;
}

}  // namespace remeshd::test
