#pragma once

#include <string>
#include <vector>

#include "server/config/command_line.h"
#include "server/config/settings.h"

namespace remeshd {

/// What the program was told to do, and how.
struct Configuration {
  Task task = Task::Serve;
  Settings settings;
  std::string health_address;  ///< as CommandLine has them
  std::string health_service;
  std::optional<std::string> answer;  ///< as CommandLine::answer
};

/// Reads the configuration file, then the environment, then the arguments; each overrides what
/// stands before it, lists as a whole.
/// Throws ConfigError with the place of what is wrong.
Configuration read_configuration(std::vector<std::string> arguments,
                                 const std::vector<std::string>& environment);

/// Checks the settings as far as that can be done before the daemon starts, beyond the range of
/// each value.
/// Throws ConfigError, SecretFileError or Error(LISTEN_INVALID).
void check_settings(const Settings& settings);

/// Whom `--health` asks: the address that it names, else the daemon of these settings, at its Unix
/// socket where it has one. Throws ConfigError where that is not known (port 0).
std::string health_address(const Configuration& configuration);

/// As a file that `read_config_file` reads back: every option, with its help as a comment.
std::string print_config(const Settings& settings);

}  // namespace remeshd
