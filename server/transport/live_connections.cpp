#include "server/transport/live_connections.h"

#include <sys/stat.h>

#include <algorithm>

namespace remeshd {
namespace {

/// Inode number of a socket; 0 for a descriptor that is none.
ino_t socket_number(int descriptor) {
  struct stat file {};
  return ::fstat(descriptor, &file) == 0 && S_ISSOCK(file.st_mode) ? file.st_ino : 0;
}

}  // namespace

void LiveConnections::forget_closed() {
  // In a flood of connections above the limit not every one is to cost a look at all others.
  constexpr std::chrono::milliseconds kPause(5);
  const Clock::time_point now = Clock::now();
  if (now - looked_ < kPause) return;
  looked_ = now;
  std::erase_if(sockets_,
                [](const auto& entry) { return socket_number(entry.first) != entry.second; });
}

std::size_t LiveConnections::count() {
  forget_closed();
  return sockets_.size();
}

bool LiveConnections::admit(int descriptor) {
  sockets_.erase(descriptor);  // whatever had the descriptor before has been closed
  if (sockets_.size() >= limit_) forget_closed();
  if (sockets_.size() >= limit_) return false;
  sockets_.emplace(descriptor, socket_number(descriptor));
  return true;
}

}  // namespace remeshd
