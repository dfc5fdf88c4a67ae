#include "server/service/remesh_service.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "remesh/v1/remesh.grpc.pb.h"
#include "server/service/call.h"
#include "server/service/decode.h"
#include "server/service/edit_stream.h"
#include "server/service/encode.h"
#include "server/service/mesh_call.h"
#include "server/service/request_id.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
using Context = grpc::CallbackServerContext;
using Bytes = grpc::ByteBuffer;
using Reply = grpc::ServerUnaryReactor;

using S0 = v1::Remesh::Service;
using S1 = v1::Remesh::WithRawCallbackMethod_CreateRevision<S0>;
using S2 = v1::Remesh::WithRawCallbackMethod_EditRevision<S1>;
using S3 = v1::Remesh::WithRawCallbackMethod_EditStream<S2>;
using S4 = v1::Remesh::WithRawCallbackMethod_GetMesh<S3>;
using S5 = v1::Remesh::WithRawCallbackMethod_Compare<S4>;
using S6 = v1::Remesh::WithRawCallbackMethod_ListRevisions<S5>;
using S7 = v1::Remesh::WithRawCallbackMethod_ListDesigns<S6>;
using S8 = v1::Remesh::WithRawCallbackMethod_DescribeRevision<S7>;
using S9 = v1::Remesh::WithRawCallbackMethod_DeleteRevision<S8>;
using S10 = v1::Remesh::WithRawCallbackMethod_ValidateModel<S9>;
using S11 = v1::Remesh::WithRawCallbackMethod_ValidateEdit<S10>;
using S12 = v1::Remesh::WithRawCallbackMethod_ListFeatureTypes<S11>;
using RawService = v1::Remesh::WithRawCallbackMethod_GetServerInfo<S12>;

constexpr std::uint32_t kMostRows = 1000;

int page(std::uint32_t wanted) {
  return static_cast<int>(wanted == 0 ? kMostRows : std::min(wanted, kMostRows));
}

/// A page token is `number@design` of the last row sent.
std::pair<std::string, std::uint32_t> read_token(const std::string& token) {
  if (token.empty()) return {"", 0};
  std::uint32_t number = 0;
  const char* end = token.data() + token.size();
  const auto parsed = std::from_chars(token.data(), end, number);
  if (parsed.ec != std::errc{} || parsed.ptr == end || *parsed.ptr != '@')
    throw error::option_invalid("page_token", "is not one of this server's");
  return {std::string(parsed.ptr + 1, end), number};
}

class RemeshService final : public RawService {
 public:
  RemeshService(Session& session, ServiceOptions options)
      : session_(session), options_(std::move(options)) {}

  Reply* CreateRevision(Context* context, const Bytes* in, Bytes* out) override {
    return make<v1::CreateRevisionRequest>(
        "CreateRevision", context, in, out,
        [this](const v1::CreateRevisionRequest& request, Listener listener) {
          return session_.create(decode(request), std::move(listener));
        });
  }
  Reply* EditRevision(Context* context, const Bytes* in, Bytes* out) override {
    return make<v1::EditRevisionRequest>(
        "EditRevision", context, in, out,
        [this](const v1::EditRevisionRequest& request, Listener listener) {
          return session_.edit(decode(request), std::move(listener));
        });
  }
  grpc::ServerBidiReactor<Bytes, Bytes>* EditStream(Context* context) override {
    return remeshd::EditStream::start(session_, options_.message_bytes,
                                      record("EditStream", context));
  }
  grpc::ServerWriteReactor<Bytes>* GetMesh(Context* context, const Bytes* in) override {
    return MeshCall::start(session_, *in, options_.message_bytes, record("GetMesh", context));
  }
  Reply* Compare(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::CompareRequest>(
        "Compare", context, in, out, [this](const auto& request, const Run& run) {
          return encode(session_.compare(decode(request.original(), "original"),
                                         decode(request.modified(), "modified"), run));
        });
  }
  Reply* ListRevisions(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::ListRevisionsRequest>(
        "ListRevisions", context, in, out,
        [this](const auto& request, const Run&) { return list(request); });
  }
  Reply* ListDesigns(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::ListDesignsRequest>(
        "ListDesigns", context, in, out, [this](const auto& request, const Run&) {
          v1::ListDesignsReply reply;
          const int limit = page(request.page_size());
          for (const DesignRecord& design : session_.designs(request.page_token(), limit))
            *reply.add_designs() = encode(design);
          if (reply.designs_size() == limit)
            reply.set_next_page_token(reply.designs(limit - 1).name());
          return reply;
        });
  }
  Reply* DescribeRevision(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::DescribeRevisionRequest>(
        "DescribeRevision", context, in, out, [this](const auto& request, const Run& run) {
          return encode(session_.describe(request.revision(), run));
        });
  }
  Reply* DeleteRevision(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::DeleteRevisionRequest>(
        "DeleteRevision", context, in, out, [this](const auto& request, const Run&) {
          if (request.revision().empty()) throw error::reference_missing("revision");
          const auto removed = session_.remove(request.revision(), request.allow_head());
          v1::DeleteRevisionReply reply;
          reply.set_id(removed.id);
          for (const PlaceRecord& place : removed.places) *reply.add_removed() = encode(place);
          reply.set_mesh_deleted(removed.mesh_deleted);
          return reply;
        });
  }
  Reply* ValidateModel(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::ValidateModelRequest>(
        "ValidateModel", context, in, out, [this](const auto& request, const Run& run) {
          return encode(session_.validate(decode(request.model()), decode(request.options()), run));
        });
  }
  Reply* ValidateEdit(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::ValidateEditRequest>(
        "ValidateEdit", context, in, out, [this](const auto& request, const Run& run) {
          std::variant<std::string, ModelSource> base = request.base();
          if (request.has_model()) base = decode(request.model());
          return encode(
              session_.validate_edit(base, decode(request.edit()), decode(request.options()), run));
        });
  }
  Reply* ListFeatureTypes(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::ListFeatureTypesRequest>(
        "ListFeatureTypes", context, in, out, [this](const auto&, const Run&) {
          v1::ListFeatureTypesReply reply;
          for (const FeatureTypeInfo& type : session_.feature_types())
            *reply.add_types() = encode(type);
          return reply;
        });
  }
  Reply* GetServerInfo(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::GetServerInfoRequest>(
        "GetServerInfo", context, in, out,
        [this](const auto&, const Run&) { return server_info(); });
  }

 private:
  std::shared_ptr<CallRecord> record(const char* method, Context* context) const {
    return std::make_shared<CallRecord>(options_.log, method, context->peer());
  }

  /// A call that makes a revision: decode, hand to the session, encode what comes back.
  template <typename Request, typename Start>
  Reply* make(const char* method, Context* context, const Bytes* in, Bytes* out, Start start) {
    const auto call = UnaryCall::start(out, record(method, context));
    answering(*call, [&] {
      Request request;
      from_bytes(*in, options_.message_bytes, request);
      const std::string id = request.request_id();
      call->record().set_request_id(id);
      check_request_id(id);
      const auto answer = [call, id](const Made& made) {
        answering(*call, [&] {
          call->record().set_note("revision=" + made.filed.record.id.substr(0, 12));
          call->reply(encode(made, id));
        });
      };
      const MakeRequestPtr under_way = start(
          request, Listener{.progress = {}, .made = answer, .failed = [call](const Error& why) {
                              call->fail(why);
                            }});
      call->on_cancel([under_way] { under_way->cancel(); });
    });
    return call.get();
  }

  /// A call that is answered by a function on the quick pool.
  template <typename Request, typename Answer>
  Reply* query(const char* method, Context* context, const Bytes* in, Bytes* out, Answer answer) {
    const auto call = UnaryCall::start(out, record(method, context));
    answering(*call, [&] {
      session_.later(
          [this, call, in, answer] {
            answering(*call, [&] {
              Request request;
              from_bytes(*in, options_.message_bytes, request);
              const Run run{.stop = call->stop_token(), .on_progress = {}, .dumps = {}};
              call->reply(answer(request, run));
            });
          },
          [call](const Error& why) { call->fail(why); });
    });
    return call.get();
  }

  v1::ListRevisionsReply list(const v1::ListRevisionsRequest& request) {
    v1::ListRevisionsReply reply;
    const int limit = page(request.page_size());
    const auto [design, number] = read_token(request.page_token());
    const auto rows = session_.list(request.design(), design, number, limit);
    for (const ListedRevision& row : rows) *reply.add_revisions() = encode(row.record, row.place);
    if (static_cast<int>(rows.size()) == limit)
      reply.set_next_page_token(std::to_string(rows.back().place.number) + "@" +
                                rows.back().place.design);
    return reply;
  }

  v1::ServerInfo server_info() {
    const Load load = session_.load();
    const SessionLimits& limits = session_.limits();
    v1::ServerInfo info;
    info.set_version(options_.version);
    info.set_protocol("remesh.v1");
    info.set_algorithm_version(session_.algorithm_version());
    info.mutable_started()->set_seconds(
        std::chrono::duration_cast<std::chrono::seconds>(started_.time_since_epoch()).count());
    info.set_workers(static_cast<std::uint32_t>(limits.workers));
    info.set_threads(static_cast<std::uint32_t>(limits.threads));
    info.set_queue_limit(static_cast<std::uint32_t>(limits.queue));
    info.set_running(static_cast<std::uint32_t>(load.running));
    info.set_queued(static_cast<std::uint32_t>(load.queued));
    info.set_revisions(load.revisions);
    info.set_designs(load.designs);
    info.set_cached_revisions(static_cast<std::uint32_t>(load.held));
    info.set_cached_bytes(load.held_bytes);
    info.set_cache_budget_bytes(limits.memory);
    info.set_persistent(session_.persistent());
    info.set_max_document_bytes(options_.document_bytes);
    info.set_max_nodes(limits.max_nodes);
    return info;
  }

  Session& session_;
  const ServiceOptions options_;
  const std::chrono::system_clock::time_point started_ = std::chrono::system_clock::now();
};

}  // namespace

std::unique_ptr<grpc::Service> make_remesh_service(Session& session, ServiceOptions options) {
  return std::make_unique<RemeshService>(session, std::move(options));
}

}  // namespace remeshd
