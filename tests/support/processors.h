#pragma once

#include <sched.h>

#include <vector>

namespace remeshd::test {

/// The processors that the process may use, by their numbers: those of the thread that asked
/// first, which no `OnProcessor` had kept on one of them yet.
const std::vector<int>& processors();

/// Keeps the calling thread, and all threads and processes that it starts meanwhile, on one
/// processor: the `which`th of `processors()`, counted round where there are fewer.
class OnProcessor {
 public:
  explicit OnProcessor(int which);
  OnProcessor(const OnProcessor&) = delete;
  OnProcessor& operator=(const OnProcessor&) = delete;
  ~OnProcessor();

 private:
  cpu_set_t before_{};
};

}  // namespace remeshd::test
