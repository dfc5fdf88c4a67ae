#include "server/process/service_manager.h"

#include <gtest/gtest.h>
#include <sys/un.h>

#include <cstring>

#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

/// A service manager's socket, named to this process.
class ServiceManager {
 public:
  explicit ServiceManager(const std::string& name)
      : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, name.data(), name.size());
    if (name.front() == '@') address.sun_path[0] = '\0';
    EXPECT_EQ(::bind(socket_.get(), reinterpret_cast<sockaddr*>(&address),
                     static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size())),
              0);
    ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
  }
  ~ServiceManager() { ::unsetenv("NOTIFY_SOCKET"); }
  [[nodiscard]] std::string heard() const {
    char bytes[64];
    const ssize_t got = readable(socket_) ? ::recv(socket_.get(), bytes, sizeof(bytes), 0) : 0;
    return {bytes, static_cast<std::size_t>(std::max<ssize_t>(got, 0))};
  }

 private:
  Descriptor socket_;
};

TEST(ServiceManagers, HearTheState) {
  const Folder folder;
  const ServiceManager manager(folder.file("notify"));
  EXPECT_TRUE(notify_service_manager("READY=1"));
  EXPECT_EQ(manager.heard(), "READY=1");
}

TEST(ServiceManagers, HearItOnAnAbstractSocketToo) {
  const ServiceManager manager("@remeshd-test-" + std::to_string(::getpid()));
  EXPECT_TRUE(notify_service_manager("STOPPING=1"));
  EXPECT_EQ(manager.heard(), "STOPPING=1");
}

TEST(ServiceManagers, ThatAreNotThereAreNotTold) {
  ::unsetenv("NOTIFY_SOCKET");
  EXPECT_TRUE(notify_service_manager("READY=1"));
  ::setenv("NOTIFY_SOCKET", "/no/such/socket", 1);
  EXPECT_FALSE(notify_service_manager("READY=1"));
  ::setenv("NOTIFY_SOCKET", std::string(4096, '/').c_str(), 1);
  EXPECT_FALSE(notify_service_manager("READY=1"));
  ::unsetenv("NOTIFY_SOCKET");
}

}  // namespace
}  // namespace remeshd::test
