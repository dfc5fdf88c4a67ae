#pragma once

#include <filesystem>
#include <string>

#include "server/daemon.h"

namespace remeshd {

/// All that can be configured, each by the option of its name (option_table.h).
struct Settings {
  DaemonOptions daemon;
  std::string log_level = "info";  ///< trace, debug, info, warning, error, off
  std::filesystem::path log_file;  ///< empty: stderr
};

}  // namespace remeshd
