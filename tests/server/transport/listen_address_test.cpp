#include "server/transport/listen_address.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"

namespace remeshd {
namespace {

TEST(ListenAddress, ReadsAddressesAndTellsLoopback) {
  struct Row {
    const char* text;
    const char* host;
    int port;
    std::size_t sockets;
    bool loopback;
  };
  for (const Row& row : {Row{"127.0.0.1:50051", "127.0.0.1", 50051, 1, true},
                         {"127.0.0.1:0", "127.0.0.1", 0, 1, true},
                         {"127.250.3.4:65535", "127.250.3.4", 65535, 1, true},
                         {"0.0.0.0:80", "0.0.0.0", 80, 1, false},
                         {"128.0.0.1:80", "128.0.0.1", 80, 1, false},
                         {"[::1]:50051", "[::1]", 50051, 1, true},
                         {"[::]:50051", "[::]", 50051, 1, false},
                         {"[2001:db8::7]:1", "[2001:db8::7]", 1, 1, false},
                         {"localhost:50051", "localhost", 50051, 2, true}}) {
    const ListenAddress address = parse_listen_address(row.text);
    EXPECT_EQ(address.host, row.host) << row.text;
    EXPECT_EQ(address.port, row.port) << row.text;
    EXPECT_EQ(address.sockets.size(), row.sockets) << row.text;
    EXPECT_EQ(address.is_loopback(), row.loopback) << row.text;
    EXPECT_FALSE(address.is_unix()) << row.text;
  }
}

TEST(ListenAddress, ReadsThePathOfAUnixSocket) {
  for (const char* text : {"unix:/run/remeshd.sock", "unix:///run/remeshd.sock"}) {
    const ListenAddress address = parse_listen_address(text);
    EXPECT_TRUE(address.is_unix());
    EXPECT_TRUE(address.is_loopback());
    EXPECT_EQ(address.path, "/run/remeshd.sock");
  }
}

TEST(ListenAddress, RefusesWhatIsNone) {
  for (const std::string& text : {std::string(),
                                  std::string("0"),
                                  std::string("80"),
                                  std::string(":80"),
                                  std::string(":"),
                                  std::string("nonsense"),
                                  std::string("127.0.0.1"),
                                  std::string("127.0.0.1:"),
                                  std::string("127.0.0.1:99999"),
                                  std::string("127.0.0.1:65536"),
                                  std::string("127.0.0.1:-1"),
                                  std::string("127.0.0.1:+80"),
                                  std::string("127.0.0.1: 80"),
                                  std::string("127.0.0.1:80 "),
                                  std::string("127.0.0.1:0x50"),
                                  std::string("127.0.0.1:http"),
                                  std::string("127.0.0.1:000080"),
                                  std::string("0:80"),
                                  std::string("127.1:80"),
                                  std::string("256.0.0.1:80"),
                                  std::string("1.2.3.4.5:80"),
                                  std::string("0x7f.1:80"),
                                  std::string("2130706433:80"),
                                  std::string("::1:80"),
                                  std::string("[::1]"),
                                  std::string("[::1:80"),
                                  std::string("[]:80"),
                                  std::string("[127.0.0.1]:80"),
                                  std::string("[::1]x:80"),
                                  std::string("[fe80::1%lo]:80"),
                                  std::string("dns:///x"),
                                  std::string("dns:///localhost:80"),
                                  std::string("ipv4:127.0.0.1:80"),
                                  std::string("http://localhost:80"),
                                  std::string("local host:80"),
                                  std::string("*:80"),
                                  std::string("-x:80"),
                                  std::string(".:80"),
                                  std::string("a..b:80"),
                                  std::string("no-such-host.invalid:80"),
                                  std::string("127.0.0.1:80,[::1]:80"),
                                  std::string("localhost\0:80", 13),
                                  std::string("unix:"),
                                  std::string("unix:relative"),
                                  std::string("unix:/"),
                                  std::string("unix:/folder/"),
                                  std::string("unix:/a\0b", 9),
                                  "unix:/" + std::string(107, 'x'),
                                  std::string("unix-abstract:x"),
                                  std::string(300, 'a') + ":80"}) {
    try {
      parse_listen_address(text);
      ADD_FAILURE() << '`' << text << "` is taken for an address";
    } catch (const Error& error) {
      EXPECT_EQ(error.info().kind, ErrorKind::InvalidArgument);
      EXPECT_EQ(error.info().reason, "LISTEN_INVALID");
      EXPECT_NE(error.info().message.find('`' + text + '`'), std::string::npos);
      EXPECT_FALSE(error.info().hint.empty());
    }
  }
}

}  // namespace
}  // namespace remeshd
