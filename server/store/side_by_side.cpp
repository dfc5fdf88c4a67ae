#include "server/store/side_by_side.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <system_error>
#include <thread>

namespace remeshd {
namespace {

// More threads gain little, and others want a processor too.
constexpr std::size_t kMostThreads = 4;

}  // namespace

void do_side_by_side(const std::vector<std::function<void()>>& jobs) {
  std::vector<std::exception_ptr> failures(jobs.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < jobs.size(); k = next++) {
      try {
        jobs[k]();
      } catch (...) {
        failures[k] = std::current_exception();
      }
    }
  };
  std::vector<std::future<void>> helpers;
  const std::size_t threads =
      std::min({jobs.size(), kMostThreads, std::size_t{std::thread::hardware_concurrency()}});
  try {
    while (helpers.size() + 1 < threads) helpers.push_back(std::async(std::launch::async, work));
  } catch (const std::system_error&) {
    // No thread is to be had: the jobs are done by those there are.
  }
  work();
  for (std::future<void>& helper : helpers) helper.wait();
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace remeshd
