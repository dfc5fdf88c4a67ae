#pragma once

#include <string>
#include <vector>

#include "server/config/given_option.h"

namespace remeshd {

/// What the environment says of the configuration.
struct Environment {
  std::vector<GivenOption> given;
  std::string config_file;  ///< REMESHD_CONFIG
};

/// Reads `Option::variable` of every option out of `NAME=value` texts. A variable without a value
/// counts as not set: compose files pass on empty ones. Those that Kubernetes makes for services
/// `remeshd...` (REMESHD_PORT..., REMESHD_SERVICE_...) are passed over, since nobody chose them.
///
/// Throws ConfigError for any other REMESHD_* that is unknown, and where a text is no value of the
/// option's kind.
Environment read_environment(const std::vector<std::string>& settings);

/// This process' environment.
std::vector<std::string> process_environment();

}  // namespace remeshd
