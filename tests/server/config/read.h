#pragma once

#include <gmock/gmock.h>

#include <fstream>

#include "server/config/config_error.h"
#include "server/config/configuration.h"
#include "tests/server/transport/sockets.h"

namespace remeshd::test {

/// What the ConfigError says that `work` throws; fails the test where it throws none.
template <typename Work>
std::string complaint(Work&& work) {
  try {
    work();
  } catch (const ConfigError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no ConfigError";
  return "";
}

/// A configuration file that is gone after the test.
class ConfigFile {
 public:
  explicit ConfigFile(const std::string& text) { std::ofstream(path()) << text; }
  [[nodiscard]] std::string path() const { return folder_.file("remeshd.toml"); }

 private:
  Folder folder_;
};

}  // namespace remeshd::test
