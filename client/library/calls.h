// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/support/status.h>
#include <grpcpp/support/sync_stream.h>

#include <chrono>
#include <string>
#include <vector>

#include "client/library/call_context.h"
#include "client/library/search.h"
#include "client/library/status.h"

namespace remeshd::client {

/// ms for a connection to be made, before a request that is not to be sent twice.
inline constexpr std::chrono::milliseconds kConnect(1000);

template <class Service, class Request, class Reply>
using Method = grpc::Status (Service::*)(grpc::ClientContext*, const Request&, Reply*);

template <class Service, class Request, class Reply>
grpc::Status ask(const Search& search, const Replica& replica,
                 Method<Service, Request, Reply> method, const Request& request, Reply& reply) {
  CallContext context(search.rest(), replica, search.route());
  return (replica.of(static_cast<const Service*>(nullptr)).*method)(context.get(), request, &reply);
}

/// A call that may be made twice: it changes nothing, or names what it makes by what it is made of.
template <class Service, class Request, class Reply>
Reply call_again(Search search, Method<Service, Request, Reply> method, const Request& request) {
  while (true) {
    Reply reply;
    Replica& replica = search.replica();
    const grpc::Status status = ask(search, replica, method, request, reply);
    if (!status.ok() && search.goes_on(replica, status)) continue;
    check(status);
    search.heard(replica);
    return reply;
  }
}

/// A call that changes something. It is made again where a daemon refused it with a reason and, if
/// there are several daemons, where one cannot be reached. It is not made again where the
/// connection breaks, since it may have been carried out; with a single daemon, one that cannot be
/// reached counts as such a break.
template <class Service, class Request, class Reply>
Reply call_once(const Farm& farm, Search search, Method<Service, Request, Reply> method,
                const Request& request) {
  while (true) {
    Reply reply;
    Replica& replica = search.replica();
    const bool sent = !farm.several() || replica.connects(kConnect);
    const grpc::Status status =
        sent ? ask(search, replica, method, request, reply)
             : grpc::Status(grpc::StatusCode::UNAVAILABLE, "no connection to " + replica.address);
    const bool perhaps_done = sent && is_broken(status) &&
                              error_of(status).reason() == remesh::v1::Error::REASON_UNSPECIFIED;
    if (!status.ok() && !perhaps_done && search.goes_on(replica, status)) continue;
    check(status);
    search.heard(replica);
    return reply;
  }
}

/// All pages of a list, from one daemon.
template <class Service, class Request, class Reply, class Item>
std::vector<Item> all_pages(Search search, Method<Service, Request, Reply> method, Request request,
                            const google::protobuf::RepeatedPtrField<Item>& (Reply::*items)()
                                const) {
  std::vector<Item> all;
  const Replica* from = nullptr;
  while (true) {
    Reply page;
    Replica& replica = search.replica();
    if (&replica != from) {  // the pages so far are another daemon's
      all.clear();
      request.clear_page_token();
      from = &replica;
    }
    const grpc::Status status = ask(search, replica, method, request, page);
    if (!status.ok()) {
      if (!search.goes_on(replica, status)) check(status);
      continue;
    }
    search.heard(replica);
    all.insert(all.end(), (page.*items)().begin(), (page.*items)().end());
    request.set_page_token(page.next_page_token());
    if (request.page_token().empty()) return all;
  }
}

/// Hands all messages of a transfer to `take`; cancels the call where that throws.
template <class Response>
grpc::Status read_all(grpc::ClientReader<Response>& reader, CallContext& context,
                      const auto& take) {
  Response response;
  try {
    while (reader.Read(&response)) take(response);
  } catch (...) {
    context.cancel();
    reader.Finish();
    throw;
  }
  return reader.Finish();
}

}  // namespace remeshd::client
