#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "remesh/v1/server.pb.h"
#include "server/observe/readiness.h"
#include "server/service/request_limits.h"
#include "server/session/session.h"

namespace remeshd {

/// What the session does not know of the daemon that it is in.
struct ServerFacts {
  std::string version;
  std::uint32_t connections = 0;  ///< at most; 0: no limit of its own
  std::uint32_t streams = 0;      ///< likewise, of calls at a time on one connection
  std::chrono::system_clock::time_point started = std::chrono::system_clock::now();
  const Readiness* readiness = nullptr;                             ///< null: always ready
  std::function<std::size_t()> open_connections{}, open_streams{};  ///< empty: not counted
};

/// Capabilities, limits and load of this daemon.
remesh::v1::ServerInfo server_info(Session& session, const ServerFacts& facts,
                                   const RequestLimits& limits);

}  // namespace remeshd
