// SPDX-License-Identifier: Apache-2.0
#include "client/library/routes.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>

#include "client/library/call_context.h"
#include "client/library/search.h"
#include "client/library/status.h"
#include "proto/checksum.h"

namespace remeshd::client {
namespace {

constexpr std::size_t kShortestId = 8, kKeyDigits = 16;
constexpr const char* kUnnamed = "model";  ///< the design of a model without a name

/// Name of the model, and so of the design that it joins by default; empty where the document
/// cannot be read, which the daemon will tell.
std::string name_of(const remesh::v1::CreateRevisionRequest& request) {
  std::string name = request.model().name();
  if (!request.document().empty()) {
    google::protobuf::Struct document;
    if (!google::protobuf::util::JsonStringToMessage(request.document(), &document).ok()) return {};
    const auto found = document.fields().find("name");
    if (found != document.fields().end()) name = found->second.string_value();
  }
  return name.empty() ? kUnnamed : name;
}

/// The same bytes for the same message.
std::string serialised(const google::protobuf::Message& message) {
  std::string bytes;
  google::protobuf::io::StringOutputStream out(&bytes);
  google::protobuf::io::CodedOutputStream coded(&out);
  coded.SetSerializationDeterministic(true);
  message.SerializeToCodedStream(&coded);
  coded.Trim();
  return bytes;
}

}  // namespace

bool is_name(const std::string& revision) {
  return revision.size() < kShortestId ||
         revision.find_first_not_of("0123456789abcdef") != std::string::npos;
}

std::string route_of(const Farm& farm, const std::string& revision) {
  if (is_name(revision)) return revision.substr(0, revision.find('@'));
  return farm.route_of(revision).value_or("");
}

std::string looked_up_route(const std::shared_ptr<Farm>& farm, const std::string& revision,
                            const CallOptions& options) {
  if (is_name(revision)) return route_of(*farm, revision);
  if (const auto known = farm->route_of(revision)) return *known;
  remesh::v1::GetRevisionRequest request;
  request.set_revision(revision);
  Search search(farm, "", options);
  while (true) {
    Replica& replica = search.replica();
    remesh::v1::GetRevisionResponse reply;
    CallContext context(search.rest(), replica, search.route());
    const auto status = replica.service().GetRevision(context.get(), request, &reply);
    if (status.ok()) {
      search.heard(replica);
      const auto& found = reply.revision();
      const std::string& route = found.design().empty() ? found.root() : found.design();
      farm->remember_route(revision, route);
      farm->remember_route(found.id(), route);
      return route;
    }
    if (search.goes_on(replica, status)) continue;
    if (is_broken(status) || status.error_code() == grpc::StatusCode::DEADLINE_EXCEEDED)
      check(status);
    return {};  // the request itself will be told what is wrong
  }
}

std::string route_of(const remesh::v1::CreateRevisionRequest& request) {
  if (!request.design().empty()) return request.design();
  const bool filed = !request.head().has_file() || request.head().file();
  if (filed)
    if (std::string name = name_of(request); !name.empty()) return name;
  remesh::v1::CreateRevisionRequest plain = request;
  plain.clear_request_id();
  return sha256_hex(serialised(plain));
}

std::string key_of(const std::string& route) { return sha256_hex(route).substr(0, kKeyDigits); }

}  // namespace remeshd::client
