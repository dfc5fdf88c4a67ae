#include "server/process/port_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <system_error>

#include "tests/server/transport/sockets.h"

namespace remeshd::test {
namespace {

TEST(PortFiles, TellTheAddressesWhileTheDaemonServes) {
  const Folder folder;
  const std::string path = folder.file("port");
  std::ofstream(path) << "127.0.0.1:1\n";
  {
    const PortFile file(path);
    EXPECT_FALSE(std::filesystem::exists(path)) << "an earlier daemon's";
    file.write({"127.0.0.1:2", "unix:/a"});
    std::ifstream in(path);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "127.0.0.1:2\nunix:/a\n");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.file("")), {}), 1);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(PortFiles, ThatCannotBeWrittenSaySo) {
  const Folder folder;
  const PortFile file(folder.file("no/port"));
  EXPECT_THROW(file.write({"127.0.0.1:2"}), std::system_error);
}

TEST(PortFiles, WithoutANameAreNone) { PortFile("").write({"127.0.0.1:2"}); }

}  // namespace
}  // namespace remeshd::test
