#include "server/transport/accept_loop.h"

#include <gmock/gmock.h>
#include <spdlog/sinks/ostream_sink.h>
#include <sys/resource.h>

#include <condition_variable>
#include <mutex>
#include <sstream>
#include <vector>

#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

class AcceptLoops : public testing::Test {
 protected:
  void start(std::size_t most, const std::string& address = "127.0.0.1:0") {
    std::vector<ListeningSockets> sockets;
    sockets.emplace_back(parse_listen_address(address));
    loop_.emplace(
        std::move(sockets), most,
        [this](int, Descriptor connection) {
          const std::scoped_lock lock(mutex_);
          taken_.push_back(std::move(connection));
          changed_.notify_all();
        },
        log_);
  }
  [[nodiscard]] Descriptor connect() const { return connect_to(loop_->sockets().front().name()); }
  /// Waits until so many have been handed over.
  bool wait_taken(std::size_t connections) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(10),
                             [&] { return taken_.size() >= connections; });
  }
  std::size_t taken() {
    const std::scoped_lock lock(mutex_);
    return taken_.size();
  }

  std::ostringstream text_;
  std::shared_ptr<spdlog::logger> log_ = std::make_shared<spdlog::logger>(
      "test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text_));
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Descriptor> taken_;
  std::optional<AcceptLoop> loop_;
};

TEST_F(AcceptLoops, HandOverConnectionsWhoseOtherEndIsTheClients) {
  start(10);
  const Descriptor client = connect();
  ASSERT_TRUE(wait_taken(1));
  ASSERT_EQ(::send(taken_[0].get(), "x", 1, 0), 1);
  char byte = 0;
  ASSERT_TRUE(readable(client));
  EXPECT_EQ(::recv(client.get(), &byte, 1, 0), 1);
  EXPECT_EQ(byte, 'x');
}

TEST_F(AcceptLoops, WaitForNoPeerThatSaysNothing) {
  start(100);
  std::vector<Descriptor> mute;
  for (int i = 0; i < 50; ++i) mute.push_back(connect());
  EXPECT_TRUE(wait_taken(50));
}

TEST_F(AcceptLoops, CloseAtOnceWhatIsAboveTheLimitAndSaySo) {
  start(2);
  const Descriptor first = connect();
  const Descriptor second = connect();
  ASSERT_TRUE(wait_taken(2));
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(closed_by_peer(connect()));
  EXPECT_EQ(taken(), 2U);
  loop_->stop();
  EXPECT_THAT(text_.str(), testing::HasSubstr("--max-connections"));
  EXPECT_EQ(std::ranges::count(text_.str(), '\n'), 1) << text_.str();
}

TEST_F(AcceptLoops, TakeConnectionsAgainOnceOthersHaveEnded) {
  start(2);
  Descriptor first = connect();
  const Descriptor second = connect();
  ASSERT_TRUE(wait_taken(2));
  {
    const std::scoped_lock lock(mutex_);
    taken_[0].reset();
  }
  std::vector<Descriptor> more;
  for (int i = 0; i < 1000 && taken() < 3; ++i) {
    more.push_back(connect());
    ::usleep(2000);
  }
  EXPECT_EQ(taken(), 3U);
}

/// While it lives, this process may open no file beyond those whose number is below `limit`.
class DescriptorLimit {
 public:
  explicit DescriptorLimit(rlim_t limit) {
    ::getrlimit(RLIMIT_NOFILE, &before_);
    const rlimit low{.rlim_cur = limit, .rlim_max = before_.rlim_max};
    EXPECT_EQ(::setrlimit(RLIMIT_NOFILE, &low), 0);
    // Numbers that are free below it.
    for (int copy = ::dup(0); copy >= 0; copy = ::dup(0)) fill_.emplace_back(copy);
  }
  ~DescriptorLimit() { ::setrlimit(RLIMIT_NOFILE, &before_); }
  DescriptorLimit(const DescriptorLimit&) = delete;
  DescriptorLimit& operator=(const DescriptorLimit&) = delete;

 private:
  rlimit before_{};
  std::vector<Descriptor> fill_;
};

class ClientsWithoutDescriptors : public AcceptLoops {
 protected:
  /// Connects sockets that exist already: the other ends find no descriptor.
  void connect_all() {
    const ListenAddress address = parse_listen_address(loop_->sockets().front().name());
    const SocketAddress& socket = address.sockets.front();
    for (const Descriptor& client : clients_)
      EXPECT_EQ(
          ::connect(client.get(), reinterpret_cast<const sockaddr*>(&socket.storage), socket.size),
          0);
  }
  void start_and_open_clients() {
    start(1000);
    const Descriptor first = connect();
    ASSERT_TRUE(wait_taken(1));
    for (int i = 0; i < 5; ++i)
      clients_.emplace_back(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  }
  std::vector<Descriptor> clients_;
};

TEST_F(ClientsWithoutDescriptors, AreRefusedByMeansOfTheSpareOne) {
  start_and_open_clients();
  {
    const DescriptorLimit limit(clients_.back().get() + 1);
    connect_all();
    for (const Descriptor& client : clients_) EXPECT_TRUE(closed_by_peer(client));
  }
  EXPECT_EQ(taken(), 1U);
  const Descriptor after = connect();
  EXPECT_TRUE(wait_taken(2));
}

TEST_F(ClientsWithoutDescriptors, WaitWhereTheSpareOneIsOfNoUse) {
  start_and_open_clients();
  {
    const DescriptorLimit limit(0);
    connect_all();
    ::usleep(100'000);  // some rounds of the loop
    EXPECT_EQ(taken(), 1U);
  }
  EXPECT_TRUE(wait_taken(2));
}

TEST_F(AcceptLoops, ListenNoMoreOnceStopped) {
  start(10);
  const std::string address = loop_->sockets().front().name();
  loop_->stop();
  loop_->stop();
  EXPECT_FALSE(connect_to(address).is_open());
}

TEST_F(AcceptLoops, WorkOnUnixSockets) {
  const Folder folder;
  start(10, "unix:" + folder.file("socket"));
  const Descriptor client = connect();
  EXPECT_TRUE(wait_taken(1));
  loop_->stop();
  EXPECT_FALSE(std::filesystem::exists(folder.file("socket")));
}

}  // namespace
}  // namespace remeshd::test
