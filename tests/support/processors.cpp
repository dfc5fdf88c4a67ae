#include "tests/support/processors.h"

#include <cstddef>

namespace remeshd::test {

const std::vector<int>& processors() {
  static const std::vector<int> all = [] {
    cpu_set_t set;
    CPU_ZERO(&set);
    ::sched_getaffinity(0, sizeof set, &set);
    std::vector<int> numbers;
    for (int i = 0; i < CPU_SETSIZE; ++i)
      if (CPU_ISSET(i, &set)) numbers.push_back(i);
    return numbers;
  }();
  return all;
}

OnProcessor::OnProcessor(int which) {
  ::sched_getaffinity(0, sizeof before_, &before_);
  const std::vector<int>& all = processors();
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(all[static_cast<std::size_t>(which) % all.size()], &one);
  ::sched_setaffinity(0, sizeof one, &one);
}

OnProcessor::~OnProcessor() { ::sched_setaffinity(0, sizeof before_, &before_); }

}  // namespace remeshd::test
