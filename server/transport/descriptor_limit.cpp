#include "server/transport/descriptor_limit.h"

#include <sys/resource.h>

#include <algorithm>
#include "server/limits.h"

namespace remeshd {

void raise_descriptor_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == limit.rlim_max) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

std::size_t connections_within_descriptors(std::size_t wanted) {
  constexpr rlim_t kReserve = limits::kOwnDescriptors;
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return wanted;
  const rlim_t most =
      limit.rlim_cur >= 2 * kReserve ? limit.rlim_cur - kReserve : limit.rlim_cur / 2;
  return std::min<std::size_t>(wanted, std::max<rlim_t>(most, 1));
}

}  // namespace remeshd
