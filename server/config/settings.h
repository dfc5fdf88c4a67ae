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
  std::string acknowledge = "local";          ///< or `tier`: what has to have acknowledged edits
  std::string s3_region;                      ///< requests are signed for S3; empty: they are not
  std::filesystem::path s3_credentials_file;  ///< has `ACCESS_KEY SECRET_KEY`
};

/// Where names and heads of designs are, beyond the daemon's own store.
struct DesignSettings {
  std::string catalogue;              ///< a PostgreSQL database, as libpq takes it; empty: none
  std::vector<std::string> replicas;  ///< addresses of all daemons of the farm; empty: it is alone
  std::string replica;                ///< this daemon's address, one of `replicas`
};

/// All that can be configured, each by the option of its name (option_table.h).
struct Settings {
  DaemonOptions daemon;
  LogOptions log;
  std::filesystem::path health_socket;  ///< a Unix socket to listen on too; empty: none
  std::filesystem::path port_file;      ///< file to write the addresses served to; empty: none
  std::string metrics;                  ///< HOST:PORT to serve metrics on; empty: none
  bool insecure_metrics = false;        ///< other machines may be able to reach `metrics`
  std::filesystem::path token_file;     ///< tokens of the tenants; empty: no tokens are asked for
  TierSettings tier;
  DesignSettings designs;
  bool behind_proxy = false;  ///< addresses that other machines reach need no mutual TLS
  double grace = 10;          ///< s that requests may go on after a signal to end
};

}  // namespace remeshd
