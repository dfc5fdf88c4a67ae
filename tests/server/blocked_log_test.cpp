#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>

#include <csignal>

#include "server/observe/log.h"
#include "tests/server/daemon_fixture.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

class BlockedLogs : public DaemonTest {};

bool takes_more(const Descriptor& pipe) {
  pollfd wanted{.fd = pipe.get(), .events = POLLOUT, .revents = 0};
  return ::poll(&wanted, 1, 0) == 1;
}

TEST_F(BlockedLogs, StopNoCall) {
  std::signal(SIGPIPE, SIG_IGN);  // as the daemon does; the reader goes before the log's thread
  const Folder folder;
  const std::string path = folder.file("log");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const Descriptor reader(::open(path.c_str(), O_RDONLY | O_NONBLOCK));  // which never reads
  Log log({.file = path, .queue = 16});
  const Descriptor pipe(::open(path.c_str(), O_WRONLY | O_NONBLOCK));
  options_.log = log.logger();
  start();
  ASSERT_TRUE(serves());
  const std::string large(1000, 'x');
  while (takes_more(pipe)) {
    log.logger()->info(large);
    log.flush(std::chrono::milliseconds(50));
  }
  // From here on the log's thread waits for its reader; the queue is full of these.
  for (int i = 0; i < 32; ++i) log.logger()->info(large);
  const std::uint64_t before = log.dropped();
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(serves());
  EXPECT_GE(log.dropped(), before + 100 - 16);
  stop();
}

}  // namespace
}  // namespace remeshd::test
