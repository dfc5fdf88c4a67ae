#include <atomic>
#include <map>
#include <thread>

#include "tests/server/daemon_fixture.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

using testing::HasSubstr;

/// A connection that speaks HTTP/2 by hand (RFC 9113).
class RawConnection {
 public:
  explicit RawConnection(const std::string& address) : socket_(connect_to(address)) {}

  void send(const std::string& bytes) const {
    ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }
  void begin() const { send("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n" + frame(kSettings, "")); }
  void ping() const { send(frame(kPing, "pingping")); }

  struct Frame {
    int type = -1;  ///< -1: the connection has ended
    int flags = 0;
    std::string payload;
  };
  Frame read() const {
    const std::string head = bytes(9);
    if (head.size() < 9) return {};
    return {.type = byte(head, 3),
            .flags = byte(head, 4),
            .payload = bytes(static_cast<std::size_t>(number(head, 0, 3)))};
  }
  /// The next frame of a type, or the end.
  Frame read(int type) const {
    Frame frame = read();
    while (frame.type >= 0 && frame.type != type) frame = read();
    return frame;
  }

  static constexpr int kSettings = 4, kPing = 6, kGoAway = 7;
  static int byte(const std::string& text, std::size_t at) {
    return static_cast<unsigned char>(text[at]);
  }
  static std::uint32_t number(const std::string& text, std::size_t at, int length) {
    std::uint32_t value = 0;
    for (int i = 0; i < length; ++i)
      value = value << 8U | static_cast<unsigned>(byte(text, at + i));
    return value;
  }

 private:
  static std::string frame(int type, const std::string& payload) {
    std::string head(9, '\0');
    head[2] = static_cast<char>(payload.size());
    head[3] = static_cast<char>(type);
    return head + payload;
  }
  std::string bytes(std::size_t count) const {
    std::string out(count, '\0');
    std::size_t have = 0;
    while (have < count && readable(socket_)) {
      const ssize_t got = ::recv(socket_.get(), out.data() + have, count - have, 0);
      if (got <= 0) break;
      have += static_cast<std::size_t>(got);
    }
    out.resize(have);
    return out;
  }

  Descriptor socket_;
};

class Connections : public DaemonTest {
 protected:
  /// A channel with a connection of its own, and one call over it.
  grpc::Status call_on_new_channel(const std::string& address,
                                   std::shared_ptr<grpc::Channel>* keep = nullptr) {
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
    const auto channel =
        grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments);
    if (keep != nullptr) *keep = channel;
    grpc::ClientContext context;
    v1::GetServerInfoResponse reply;
    return v1::RemeshService::NewStub(channel)->GetServerInfo(&context, {}, &reply);
  }
};

TEST_F(Connections, MayHave256StreamsAtATime) {
  start();
  const RawConnection connection(daemon_->address());
  connection.begin();
  const auto settings = connection.read(RawConnection::kSettings);
  std::map<std::uint32_t, std::uint32_t> values;
  for (std::size_t at = 0; at + 6 <= settings.payload.size(); at += 6)
    values[RawConnection::number(settings.payload, at, 2)] =
        RawConnection::number(settings.payload, at + 2, 4);
  ASSERT_TRUE(values.contains(3));  // SETTINGS_MAX_CONCURRENT_STREAMS
  EXPECT_EQ(values[3], 256U);
}

TEST_F(Connections, ThatPingWithoutEndAreEnded) {
  start();
  const RawConnection connection(daemon_->address());
  connection.begin();
  for (int i = 0; i < 100; ++i) connection.ping();
  const auto last = connection.read(RawConnection::kGoAway);
  ASSERT_EQ(last.type, RawConnection::kGoAway);
  EXPECT_THAT(last.payload, HasSubstr("too_many_pings"));
  EXPECT_TRUE(serves());
}

TEST_F(Connections, ThatPingAFewTimesAreAnswered) {
  start();
  const RawConnection connection(daemon_->address());
  connection.begin();
  for (int i = 0; i < 5; ++i) connection.ping();
  for (int i = 0; i < 5; ++i) EXPECT_EQ(connection.read(RawConnection::kPing).flags, 1);
}

TEST_F(Connections, ThatSayNothingHoldNobodyUp) {
  start();
  std::vector<Descriptor> mute;
  for (int i = 0; i < 50; ++i) mute.push_back(connect_to(daemon_->address()));
  const RawConnection half(daemon_->address());
  half.send("PRI * HTT");
  EXPECT_TRUE(call_on_new_channel(daemon_->address()).ok());
}

TEST_F(Connections, AboveTheLimitAreUnavailableUntilOthersEnd) {
  options_.max_connections = 3;
  start();
  std::shared_ptr<grpc::Channel> first, second;
  EXPECT_TRUE(serves());
  EXPECT_TRUE(call_on_new_channel(daemon_->address(), &first).ok());
  EXPECT_TRUE(call_on_new_channel(daemon_->address(), &second).ok());
  EXPECT_EQ(call_on_new_channel(daemon_->address()).error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_TRUE(serves());
  second.reset();
  grpc::Status status(grpc::StatusCode::UNAVAILABLE, "");
  for (int i = 0; i < 1000 && !status.ok(); ++i) status = call_on_new_channel(daemon_->address());
  EXPECT_TRUE(status.ok()) << status.error_message();
}

TEST_F(Connections, OverAUnixSocketServeAndTheFileGoesWithTheDaemon) {
  const Folder folder;
  options_.listen = {"unix:" + folder.file("socket")};
  daemon_ = std::make_unique<Daemon>(options_, make_engine());
  EXPECT_EQ(daemon_->addresses(), options_.listen);
  EXPECT_TRUE(call_on_new_channel(daemon_->address()).ok());
  daemon_->shutdown();
  EXPECT_FALSE(std::filesystem::exists(folder.file("socket")));
}

TEST_F(Connections, ReachADaemonOnEachOfItsAddresses) {
  const Folder folder;
  options_.listen = {"unix:" + folder.file("socket"), "127.0.0.1:0", "[::1]:0"};
  daemon_ = std::make_unique<Daemon>(options_, make_engine());
  const auto addresses = daemon_->addresses();
  ASSERT_EQ(addresses.size(), 3U);
  EXPECT_EQ(addresses[1], "127.0.0.1:" + std::to_string(daemon_->port()));
  for (const std::string& address : addresses)
    EXPECT_TRUE(call_on_new_channel(address).ok()) << address;
}

TEST_F(Connections, AreClosedByShutdownAndNewOnesRefused) {
  start();
  const std::string address = daemon_->address();
  const RawConnection connection(address);
  connection.begin();
  connection.read(RawConnection::kSettings);
  daemon_->shutdown();
  while (connection.read().type >= 0) {
  }
  EXPECT_FALSE(connect_to(address).is_open());
}

}  // namespace
}  // namespace remeshd::test
