#pragma once

#include <grpcpp/impl/service_type.h>

#include <memory>

#include "server/service/front_desk.h"
#include "server/service/request_limits.h"
#include "server/service/server_info.h"
#include "server/session/tenants.h"

namespace remeshd {

struct ServiceOptions {
  ServerFacts facts;
  RequestLimits limits;
  FrontDeskPtr desk = std::make_shared<FrontDesk>();
};

/// remesh.v1.RemeshService over the sessions of all tenants, which must outlive it: every call is
/// answered from its tenant's. All methods take and give raw bytes: so messages that protobuf
/// cannot read get an answer in words, and replies are the same bytes for the same content.
std::unique_ptr<grpc::Service> make_remesh_service(Tenants& tenants, ServiceOptions options);

/// remesh.v1.CacheService, likewise.
std::unique_ptr<grpc::Service> make_cache_service(Tenants& tenants, ServiceOptions options);

}  // namespace remeshd
