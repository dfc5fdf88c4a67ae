#pragma once

#include <string>
#include <vector>

#include "server/config/given_option.h"

namespace remeshd {

/// What the environment says of the configuration.
struct Environment {
  std::vector<GivenOption> given;
  std::string config_file;            ///< REMESHD_CONFIG
  std::vector<std::string> warnings;  ///< one per unknown variable REMESHD_*
};

/// Reads `Option::variable` of every option out of `NAME=value` texts. A variable without a value
/// counts as not set: compose files pass on empty ones. An unknown REMESHD_* is a warning and no
/// error, since the daemon does not choose its environment; those that Kubernetes makes for a
/// service `remeshd` (REMESHD_PORT..., REMESHD_SERVICE_...) are not even that.
///
/// Throws ConfigError where a text is no value of the option's kind.
Environment read_environment(const std::vector<std::string>& settings);

/// This process' environment.
std::vector<std::string> process_environment();

}  // namespace remeshd
