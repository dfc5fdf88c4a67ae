#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "server/daemon.h"
#include "server/observe/log.h"

namespace remeshd {

/// The shared tier.
struct TierSettings {
  std::string place;                          ///< a URL or a folder; empty: none
  std::filesystem::path key_file;             ///< has the farm's key
  std::string acknowledge = "local";          ///< or `tier`: where an edit has to be
  std::string s3_region;                      ///< requests are signed for S3; empty: they are not
  std::filesystem::path s3_credentials_file;  ///< has `ACCESS_KEY SECRET_KEY`
};

/// Where names and heads of designs are, beyond the daemon's own store.
struct DesignSettings {
  std::string catalogue;              ///< a PostgreSQL database, as libpq takes it; empty: none
  std::vector<std::string> replicas;  ///< addresses of all daemons of the farm; empty: it is alone
  std::string replica;                ///< that of this one
};

/// All that can be configured, each by the option of its name (option_table.h).
struct Settings {
  DaemonOptions daemon;
  LogOptions log;
  std::filesystem::path health_socket;  ///< a Unix socket to listen on too; empty: none
  std::filesystem::path port_file;      ///< that tells where it serves; empty: none
  std::string metrics;                  ///< HOST:PORT to serve metrics on; empty: none
  bool insecure_metrics = false;        ///< `metrics` may be reached from elsewhere
  std::filesystem::path token_file;     ///< of Doorman; empty: none
  TierSettings tier;
  DesignSettings designs;
  bool behind_proxy = false;  ///< what may be reached from elsewhere need not have mutual TLS
  double grace = 10;          ///< s that requests may go on after a signal to end
};

}  // namespace remeshd
