#pragma once

#include <filesystem>

#include "server/daemon.h"
#include "server/observe/log.h"

namespace remeshd {

/// All that can be configured, each by the option of its name (option_table.h).
struct Settings {
  DaemonOptions daemon;
  LogOptions log;
  std::filesystem::path health_socket;  ///< a Unix socket to listen on too; empty: none
  std::filesystem::path port_file;      ///< that tells where it serves; empty: none
  double grace = 10;                    ///< s that requests may go on after a signal to end
};

}  // namespace remeshd
