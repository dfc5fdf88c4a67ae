#include "engine/base/parallel.h"

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>

namespace remeshd {

namespace {

/// Calls f(0), ..., f(count - 1).
template <class F>
void each(std::size_t count, const Run& run, const F& f) {
  if (run.threads <= 1 || count <= 1) {
    for (std::size_t k = 0; k < count; ++k) f(k);
    return;
  }
  std::vector<std::exception_ptr> thrown(count);
  // TBB orders the calls after what precedes them here and before what follows, but does so in a
  // library that ThreadSanitizer does not instrument: these atomics tell it the same.
  std::atomic<bool> begun{false};
  std::atomic<std::size_t> ended{0};
  const auto call = [&](std::size_t k) {
    begun.load(std::memory_order_acquire);
    try {
      f(k);
    } catch (...) {
      thrown[k] = std::current_exception();
    }
    ended.fetch_add(1, std::memory_order_release);
  };
  begun.store(true, std::memory_order_release);
  const int threads = std::min(run.threads, tbb::info::default_concurrency());
  tbb::task_arena arena(static_cast<int>(std::min<std::size_t>(threads, count)));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, call, tbb::simple_partitioner()); });
  ended.load(std::memory_order_acquire);
  const auto first = std::ranges::find_if(thrown, [](const auto& e) { return e != nullptr; });
  if (first != thrown.end()) std::rethrow_exception(*first);
}

}  // namespace

void in_blocks(std::size_t count, std::size_t block, const Run& run,
               const std::function<void(std::size_t, std::size_t)>& f) {
  each((count + block - 1) / block, run,
       [&](std::size_t k) { f(k * block, std::min(count, (k + 1) * block)); });
}

void side_by_side(std::initializer_list<std::function<void()>> tasks, const Run& run) {
  each(tasks.size(), run, [&](std::size_t k) { tasks.begin()[k](); });
}

}  // namespace remeshd
