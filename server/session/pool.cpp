#include "server/session/pool.h"

#include <algorithm>
#include <utility>

#include "server/session/guarded.h"
#include "server/session/session_error.h"

namespace remeshd {

Pool::Pool(Limits limits) : limits_(limits) {
  for (int i = 0; i < limits_.workers; ++i) threads_.emplace_back([this] { work(); });
  threads_.emplace_back([this] { watch(); });
}

Pool::~Pool() { shutdown(); }

double Pool::retry_delay() const {
  const double ahead = static_cast<double>(queue_.size() + running_) / limits_.workers;
  return std::clamp(mean_seconds_ * ahead, 0.1, 60.0);
}

Pool::JobId Pool::submit(std::function<void()> run, std::function<void(const Error&)> refused) {
  const std::scoped_lock lock(mutex_);
  if (ending_) throw error::shutting_down();
  const bool idle = running_ + queue_.size() < static_cast<std::size_t>(limits_.workers);
  if (!idle && queue_.size() >= limits_.queue) throw error::busy(queue_.size(), retry_delay());
  const JobId id = next_id_++;
  queue_.push_back({id, Clock::now(), std::move(run), std::move(refused)});
  wake_.notify_one();
  wake_watch_.notify_one();
  return id;
}

bool Pool::withdraw(JobId id) {
  const std::scoped_lock lock(mutex_);
  const auto job =
      std::find_if(queue_.begin(), queue_.end(), [id](const Job& j) { return j.id == id; });
  if (job == queue_.end()) return false;
  queue_.erase(job);
  return true;
}

void Pool::shutdown() {
  std::deque<Job> left;
  std::vector<std::thread> threads;
  {
    const std::scoped_lock lock(mutex_);
    ending_ = true;
    left.swap(queue_);
    threads.swap(threads_);
    wake_.notify_all();
    wake_watch_.notify_all();
  }
  for (const Job& job : left) contained([&] { job.refused(error::shutting_down()); });
  for (std::thread& thread : threads) thread.join();
}

void Pool::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return ending_ || !queue_.empty(); });
    if (ending_) return;
    Job job = std::move(queue_.front());
    queue_.pop_front();
    ++running_;
    lock.unlock();
    const auto start = Clock::now();
    contained(job.run);
    // What the job holds is let go of before the pool says that it is done with it.
    job = {};
    const std::chrono::duration<double> spent = Clock::now() - start;
    lock.lock();
    --running_;
    mean_seconds_ = 0.8 * mean_seconds_ + 0.2 * spent.count();
  }
}

void Pool::watch() {
  const std::chrono::duration<double> wait(limits_.wait);
  std::unique_lock lock(mutex_);
  while (!ending_) {
    if (queue_.empty()) {
      wake_watch_.wait(lock);
      continue;
    }
    const auto until = queue_.front().since + std::chrono::duration_cast<Clock::duration>(wait);
    if (Clock::now() < until) {
      wake_watch_.wait_until(lock, until);
      continue;
    }
    const Job job = std::move(queue_.front());
    queue_.pop_front();
    const double delay = retry_delay();
    lock.unlock();
    contained([&] { job.refused(error::waited_too_long(limits_.wait, delay)); });
    lock.lock();
  }
}

std::size_t Pool::running() const {
  const std::scoped_lock lock(mutex_);
  return running_;
}
std::size_t Pool::queued() const {
  const std::scoped_lock lock(mutex_);
  return queue_.size();
}

}  // namespace remeshd
