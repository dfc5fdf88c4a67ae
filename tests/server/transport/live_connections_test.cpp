#include "server/transport/live_connections.h"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <thread>

#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

Descriptor new_socket() { return Descriptor(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)); }

/// Admits once it has seen what was closed before.
bool admitted_soon(LiveConnections& live, const Descriptor& socket) {
  for (int i = 0; i < 1000; ++i) {
    if (live.admit(socket.get())) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

TEST(LiveConnections, AreAsManyAsMayBe) {
  LiveConnections live(3);
  std::vector<Descriptor> sockets;
  for (int i = 0; i < 4; ++i) {
    sockets.push_back(new_socket());
    EXPECT_EQ(live.admit(sockets.back().get()), i < 3) << i;
  }
}

TEST(LiveConnections, CountNoMoreOnceTheyAreClosed) {
  LiveConnections live(2);
  const Descriptor stays = new_socket();
  Descriptor goes = new_socket();
  const Descriptor next = new_socket();
  ASSERT_TRUE(live.admit(stays.get()));
  ASSERT_TRUE(live.admit(goes.get()));
  EXPECT_FALSE(live.admit(next.get()));
  goes.reset();
  EXPECT_TRUE(admitted_soon(live, next));
  const Descriptor more = new_socket();
  EXPECT_FALSE(live.admit(more.get()));
}

TEST(LiveConnections, AreGoneWhenAnotherFileHasTheirNumber) {
  LiveConnections live(1);
  Descriptor goes = new_socket();
  ASSERT_TRUE(live.admit(goes.get()));
  // Files that are no connection, a socket among them, take the number.
  const Descriptor next = new_socket();
  const Descriptor file(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  ASSERT_EQ(::dup2(file.get(), goes.get()), goes.get());
  EXPECT_TRUE(admitted_soon(live, next));

  LiveConnections other(1);
  Descriptor first = new_socket();
  ASSERT_TRUE(other.admit(first.get()));
  const Descriptor socket = new_socket();
  ASSERT_EQ(::dup2(socket.get(), first.get()), first.get());
  EXPECT_TRUE(admitted_soon(other, next));
}

}  // namespace
}  // namespace remeshd::test
