#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/config/given_option.h"

namespace remeshd {

/// What the program is to do.
enum class Task : std::uint8_t { Serve, CheckConfig, PrintConfig, Health };

struct CommandLine {
  Task task = Task::Serve;
  std::vector<GivenOption> given;
  std::string config_file;            ///< --config; empty: none
  std::string health_address;         ///< of `--health ADDRESS`; empty: the daemon's own
  std::string health_service;         ///< name that the health service is asked about
  std::optional<std::string> answer;  ///< text for --help or --version; nothing else is to be done
};

/// Reads the arguments after the program's name.
/// Throws ConfigError: an unknown flag (the nearest one is suggested), a value that is missing or
/// of the wrong kind, a flag given twice.
CommandLine read_command_line(std::vector<std::string> arguments);

}  // namespace remeshd
