// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "client/library/farm.h"
#include "remesh/v1/remesh.pb.h"
#include "remeshd/call_options.h"

namespace remeshd::client {

/// Whether `revision` is `design` or `design@number`; else it is an id or a prefix of one.
bool is_name(const std::string& revision);

/// The route of a request about a revision, as the client for Python has it: the design in its
/// name; of an id the route of its loop, where this client has made it or looked it up, else empty,
/// for which any daemon may be asked.
std::string route_of(const Farm& farm, const std::string& revision);

/// The same for a request that needs the revision in memory: an id that is not known is looked up
/// (GetRevision), and the route is its design, or its root where it is in none; empty where that
/// fails. Throws CallError where no daemon is available.
std::string looked_up_route(const std::shared_ptr<Farm>& farm, const std::string& revision,
                            const CallOptions& options);

/// The route of a first mesh: the design that it joins, in none a digest of the request.
std::string route_of(const remesh::v1::CreateRevisionRequest& request);

/// What is sent as `x-remesh-key`, by which a balancer in between sends all of a loop to one
/// replica.
std::string key_of(const std::string& route);

}  // namespace remeshd::client
