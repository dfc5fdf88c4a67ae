#include "server/admission/pool.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "server/admission/contained.h"
#include "server/admission/load_error.h"
#include "server/limits.h"

namespace remeshd {
namespace {

// Longest sleep of the thread that looks at the clock.
constexpr std::chrono::hours kLongSleep(1);

/// Lets the calling thread, and those that it starts, give way to others.
void give_way(int niceness) {
  if (niceness == 0) return;
  // Linux has a niceness for each thread. Where it cannot be set, answers come later under load.
  const int own = ::getpriority(PRIO_PROCESS, 0);
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), own + niceness);
}

FairQueue::Clock::duration seconds(double value) {
  return std::chrono::duration_cast<FairQueue::Clock::duration>(
      std::chrono::duration<double>(value));
}

}  // namespace

Pool::Pool(Limits limits)
    : limits_(limits), queue_(static_cast<std::size_t>(limits.workers), limits.queue) {
  for (int i = 0; i < limits_.workers; ++i)
    threads_.emplace_back([this] {
      give_way(limits_.niceness);
      work();
    });
  threads_.emplace_back([this] { watch(); });
}

Pool::~Pool() { shutdown(); }

double Pool::retry_delay() {
  const double ahead = static_cast<double>(queue_.waiting() + queue_.running()) / limits_.workers;
  return jitter_.of(std::clamp(mean_seconds_ * ahead, limits::kLeastDelay, limits::kMostDelay));
}

WorkId Pool::submit(Work work) {
  const std::scoped_lock lock(mutex_);
  if (ending_) throw error::shutting_down();
  if (queue_.room(work.tenant, Clock::now()) == 0)
    throw error::busy(queue_.waiting(), retry_delay());
  const WorkId id = next_id_++;
  queue_.add({.id = id, .since = Clock::now(), .work = std::move(work)});
  wake_.notify_one();
  wake_watch_.notify_one();
  return id;
}

std::size_t Pool::room(const std::string& tenant) {
  const std::scoped_lock lock(mutex_);
  return ending_ ? 0 : queue_.room(tenant, Clock::now());
}

Error Pool::busy() {
  const std::scoped_lock lock(mutex_);
  return ending_ ? error::shutting_down() : error::busy(queue_.waiting(), retry_delay());
}

void Pool::took(double spent) {
  const std::scoped_lock lock(mutex_);
  mean_seconds_ = 0.8 * mean_seconds_ + 0.2 * spent;
}

bool Pool::withdraw(WorkId id) {
  const std::scoped_lock lock(mutex_);
  return queue_.withdraw(id);
}

void Pool::shutdown() {
  std::deque<FairQueue::Entry> left;
  std::vector<std::thread> threads;
  {
    const std::scoped_lock lock(mutex_);
    ending_ = true;
    left = queue_.clear();
    threads.swap(threads_);
    wake_.notify_all();
    wake_watch_.notify_all();
  }
  for (const FairQueue::Entry& entry : left)
    contained([&] { entry.work.refused(error::shutting_down()); });
  for (std::thread& thread : threads) thread.join();
}

void Pool::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    std::optional<FairQueue::Entry> next;
    wake_.wait(lock, [&] { return ending_ || (next = queue_.take(Clock::now())); });
    if (!next) return;
    const WorkId id = next->id;
    const std::string tenant = next->work.tenant;
    const auto now = Clock::now();
    running_[id] = {.since = now, .overdue = std::move(next->work.overdue)};
    if (limits_.compute > 0) wake_watch_.notify_one();
    lock.unlock();
    if (limits_.waited) {
      const std::chrono::duration<double> waited = now - next->since;
      contained([&] { limits_.waited(waited.count()); });
    }
    contained(next->work.run);
    // Frees what the work holds before the pool counts the work as ended.
    next.reset();
    lock.lock();
    auto ended = running_.extract(id);
    queue_.ended(tenant);
    // Waiting work of this tenant, or of one that was at its limit, may get a worker now.
    wake_.notify_all();
    lock.unlock();
    ended = {};
    lock.lock();
  }
}

void Pool::refuse_late(std::unique_lock<std::mutex>& lock) {
  while (const auto late = queue_.take_older_than(Clock::now() - seconds(limits_.wait))) {
    const double delay = retry_delay();
    lock.unlock();
    contained([&] { late->work.refused(error::waited_too_long(limits_.wait, delay)); });
    lock.lock();
  }
}

void Pool::tell_overdue(std::unique_lock<std::mutex>& lock) {
  if (limits_.compute <= 0) return;
  const auto before = Clock::now() - seconds(limits_.compute);
  std::vector<std::function<void(const Error&)>> late;
  for (auto& [id, running] : running_)
    if (running.overdue && running.since <= before)
      late.push_back(std::exchange(running.overdue, nullptr));
  lock.unlock();
  for (const auto& tell : late)
    contained([&] { tell(error::compute_limit_reached(limits_.compute)); });
  late.clear();
  lock.lock();
}

Pool::Clock::time_point Pool::next_event() const {
  auto next = Clock::now() + kLongSleep;
  if (const auto oldest = queue_.oldest()) next = std::min(next, *oldest + seconds(limits_.wait));
  if (limits_.compute > 0)
    for (const auto& [id, running] : running_)
      if (running.overdue) next = std::min(next, running.since + seconds(limits_.compute));
  return next;
}

void Pool::watch() {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    refuse_late(lock);
    tell_overdue(lock);
    if (ending_) return;
    // What became due while the lock was released is handled at once, without a wait.
    if (const auto next = next_event(); Clock::now() < next) wake_watch_.wait_until(lock, next);
  }
}

std::size_t Pool::running() const {
  const std::scoped_lock lock(mutex_);
  return queue_.running();
}
std::size_t Pool::queued() const {
  const std::scoped_lock lock(mutex_);
  return queue_.waiting();
}

}  // namespace remeshd
