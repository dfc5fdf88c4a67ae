// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "client/library/farm.h"
#include "remesh/v1/remesh.pb.h"
#include "remeshd/call_options.h"

namespace remeshd::client {

/// Whether it names a revision by its design; else it is an id, or the beginning of one.
bool is_name(const std::string& revision);

/// The route of what asks for a revision, as the client for Python has it: its design; of an id
/// that of the loop it is of, where this client has made it or looked it up, else none, so that any
/// daemon is asked.
std::string route_of(const Farm& farm, const std::string& revision);

/// The same, where the revision is to be in memory: an id that is not known is looked up, for its
/// design or else its root. Throws CallError where no daemon is available.
std::string looked_up_route(const std::shared_ptr<Farm>& farm, const std::string& revision,
                            const CallOptions& options);

/// The route of a first mesh: the design that it joins, in none a digest of the request.
std::string route_of(const remesh::v1::CreateRevisionRequest& request);

/// What is sent as `x-remesh-key`, by which a balancer in between sends all of a loop to one
/// replica.
std::string key_of(const std::string& route);

}  // namespace remeshd::client
