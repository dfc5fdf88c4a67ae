#pragma once

#include <grpcpp/impl/service_type.h>

#include <memory>

#include "server/service/front_desk.h"
#include "server/service/request_limits.h"
#include "server/service/server_info.h"
#include "server/session/session.h"

namespace remeshd {

struct ServiceOptions {
  ServerFacts facts;
  RequestLimits limits;
  FrontDeskPtr desk = std::make_shared<FrontDesk>();
};

/// remesh.v1.RemeshService over a session, which must outlive it. All methods take and give raw
/// bytes: so messages that protobuf cannot read get an answer in words, and replies are the same
/// bytes for the same content.
std::unique_ptr<grpc::Service> make_remesh_service(Session& session, ServiceOptions options);

/// remesh.v1.CacheService over the same session, likewise.
std::unique_ptr<grpc::Service> make_cache_service(Session& session, ServiceOptions options);

}  // namespace remeshd
