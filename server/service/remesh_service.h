#pragma once

#include <grpcpp/impl/service_type.h>
#include <spdlog/logger.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>

#include "server/session/session.h"

namespace remeshd {

/// What GetServerInfo tells beside the session's state, and what messages may be.
struct ServiceOptions {
  std::string version;
  std::size_t document_bytes = std::size_t{4} << 20;  ///< of a JSON document
  std::size_t message_bytes = std::size_t{8} << 20;   ///< of a message
  std::shared_ptr<spdlog::logger> log;                ///< may be null
};

/// remesh.v1.Remesh over a session, which must outlive it. All methods take and give raw bytes: so
/// messages that protobuf cannot read get an answer in words, and replies are the same bytes for
/// the same content.
std::unique_ptr<grpc::Service> make_remesh_service(Session& session, ServiceOptions options);

}  // namespace remeshd
