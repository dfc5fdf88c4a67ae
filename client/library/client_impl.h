// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "client/library/farm.h"
#include "client/library/routes.h"
#include "client/library/search.h"
#include "remeshd/client.h"

namespace remeshd::client {

/// Throws CallError INVALID_ARGUMENT of the parameter `address`.
[[noreturn]] void refuse_addresses(const std::string& message, const std::string& hint);

struct Client::Impl {
  explicit Impl(std::vector<std::unique_ptr<Replica>> replicas)
      : farm(std::make_shared<Farm>(std::move(replicas))) {}

  /// The search for the daemon that a call goes to; a route in `call` comes before `route`.
  /// `search_for`: for a call about a revision, by its name alone.
  Search search(const std::string& route, const CallOptions& call) const {
    return {farm, call.route.value_or(route), call};
  }
  Search search_for(const std::string& revision, const CallOptions& call) const {
    return search(route_of(*farm, revision), call);
  }
  /// For a call that needs the mesh of a revision: looks its route up where it is not known, to
  /// find the daemon that has the mesh in memory.
  Search search_mesh(const std::string& revision, const CallOptions& call) const {
    return search(call.route ? *call.route : looked_up_route(farm, revision, call), call);
  }
  /// For calls about the cache, which each daemon has for itself. Throws CallError INVALID_ARGUMENT
  /// where there are several daemons.
  Search search_cache(const CallOptions& call) const {
    if (farm->several())
      refuse_addresses("each daemon has a cache of its own, and several addresses are given",
                       "connect to the one that is meant");
    return search("", call);
  }
  remesh::v1::RevisionResult made(remesh::v1::RevisionResult result,
                                  const std::string& route) const {
    farm->remember_route(result.revision().id(), route);
    return result;
  }

  const std::shared_ptr<Farm> farm;
};

}  // namespace remeshd::client
