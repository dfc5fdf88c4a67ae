#include "server/service/remesh_service.h"

#include <utility>

#include "remesh/v1/remesh.grpc.pb.h"
#include "server/service/call.h"
#include "server/service/count_made.h"
#include "server/service/decode.h"
#include "server/service/edit_stream.h"
#include "server/service/encode.h"
#include "server/service/encode_cache.h"
#include "server/service/lists.h"
#include "server/service/located.h"
#include "server/service/mesh_call.h"
#include "server/service/mesh_file_call.h"
#include "server/service/motion_calls.h"
#include "server/service/query.h"
#include "server/service/raw_service.h"
#include "server/service/remake.h"
#include "server/service/request_id.h"
#include "server/session/fail_on.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;
using Remesh = v1::RemeshService;
using Context = grpc::CallbackServerContext;
using Bytes = grpc::ByteBuffer;
using Reply = grpc::ServerUnaryReactor;

using RawService = RawMethods<
    Remesh::Service, Remesh::WithRawCallbackMethod_CreateRevision,
    Remesh::WithRawCallbackMethod_EditRevision, Remesh::WithRawCallbackMethod_EditStream,
    Remesh::WithRawCallbackMethod_GetMesh, Remesh::WithRawCallbackMethod_GetMeshFile,
    Remesh::WithRawCallbackMethod_GetRevision, Remesh::WithRawCallbackMethod_GetRecipe,
    Remesh::WithRawCallbackMethod_RemakeRevision, Remesh::WithRawCallbackMethod_ListRevisions,
    Remesh::WithRawCallbackMethod_ListDesigns, Remesh::WithRawCallbackMethod_SetHead,
    Remesh::WithRawCallbackMethod_DeleteRevision, Remesh::WithRawCallbackMethod_DeleteDesign,
    Remesh::WithRawCallbackMethod_Compare, Remesh::WithRawCallbackMethod_ValidateModel,
    Remesh::WithRawCallbackMethod_ValidateEdit, Remesh::WithRawCallbackMethod_ListFeatureTypes,
    Remesh::WithRawCallbackMethod_GetDesignVelocities,
    Remesh::WithRawCallbackMethod_GetDesignGradient,
    Remesh::WithRawCallbackMethod_GetConnectivityHorizon,
    Remesh::WithRawCallbackMethod_GetServerInfo>::Type;

class RawRemeshService final : public RawService {
 public:
  RawRemeshService(Tenants& tenants, ServiceOptions options)
      : tenants_(tenants), options_(std::move(options)) {}

  Reply* CreateRevision(Context* context, const Bytes* in, Bytes* out) override {
    return make<v1::CreateRevisionRequest, v1::CreateRevisionResponse>("CreateRevision", context,
                                                                       in, out);
  }
  Reply* EditRevision(Context* context, const Bytes* in, Bytes* out) override {
    return make<v1::EditRevisionRequest, v1::EditRevisionResponse>("EditRevision", context, in,
                                                                   out);
  }
  Reply* RemakeRevision(Context* context, const Bytes* in, Bytes* out) override {
    return work_on_query<v1::RemakeRevisionRequest>(
        tenants_, options_, {"RemakeRevision", Lane::Preparation}, context, *in, out, remake_for);
  }
  grpc::ServerBidiReactor<Bytes, Bytes>* EditStream(Context* context) override {
    return remeshd::EditStream::start(tenants_, options_.limits, context,
                                      record("EditStream", context));
  }
  grpc::ServerWriteReactor<Bytes>* GetMesh(Context* context, const Bytes* in) override {
    return work_on_stream<v1::GetMeshRequest>(tenants_, options_, "GetMesh", context, *in,
                                              send_mesh);
  }
  grpc::ServerWriteReactor<Bytes>* GetMeshFile(Context* context, const Bytes* in) override {
    return work_on_stream<v1::GetMeshFileRequest>(tenants_, options_, "GetMeshFile", context, *in,
                                                  send_mesh_file);
  }

  grpc::ServerWriteReactor<Bytes>* GetDesignVelocities(Context* context, const Bytes* in) override {
    return work_on_stream<v1::GetDesignVelocitiesRequest>(tenants_, options_, "GetDesignVelocities",
                                                          context, *in, send_velocities);
  }
  Reply* GetDesignGradient(Context* context, const Bytes* in, Bytes* out) override {
    return work_on_query<v1::GetDesignGradientRequest>(tenants_, options_,
                                                       {"GetDesignGradient", Lane::Preparation},
                                                       context, *in, out, reply_gradient);
  }
  Reply* GetConnectivityHorizon(Context* context, const Bytes* in, Bytes* out) override {
    return work_on_query<v1::GetConnectivityHorizonRequest>(
        tenants_, options_, {"GetConnectivityHorizon", Lane::Preparation}, context, *in, out,
        reply_horizons);
  }

  Reply* GetRevision(Context* context, const Bytes* in, Bytes* out) override {
    return work_on_query<v1::GetRevisionRequest>(
        tenants_, options_, {"GetRevision", Lane::Preparation}, context, *in, out, describe_for);
  }
  Reply* GetRecipe(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::GetRecipeRequest>("GetRecipe", Lane::Preparation, context, in, out,
                                       [](Session& session, const auto& request, const Run&) {
                                         return encode(session.recipe(request.revision()));
                                       });
  }
  Reply* ListRevisions(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::ListRevisionsRequest>("ListRevisions", Lane::Metadata, context, in, out,
                                           [](Session& session, const auto& request, const Run&) {
                                             return list_revisions(session, request);
                                           });
  }
  Reply* ListDesigns(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::ListDesignsRequest>("ListDesigns", Lane::Metadata, context, in, out,
                                         [](Session& session, const auto& request, const Run&) {
                                           return list_designs(session, request);
                                         });
  }

  Reply* SetHead(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::SetHeadRequest>("SetHead", Lane::Preparation, context, in, out,
                                     [](Session& session, const auto& request, const Run&) {
                                       if (request.revision().empty())
                                         throw error::reference_missing("revision");
                                       const auto set =
                                           session.set_head(request.revision(), request.design(),
                                                            request.expected());
                                       v1::SetHeadResponse reply;
                                       *reply.mutable_design() = encode(set.design);
                                       reply.set_previous(set.previous);
                                       return reply;
                                     });
  }
  Reply* DeleteRevision(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::DeleteRevisionRequest>("DeleteRevision", Lane::Preparation, context, in, out,
                                            [](Session& session, const auto& request, const Run&) {
                                              if (request.revision().empty())
                                                throw error::reference_missing("revision");
                                              const auto removed = session.remove(
                                                  request.revision(), request.allow_head());
                                              v1::DeleteRevisionResponse reply;
                                              reply.set_id(removed.id);
                                              for (const PlaceRecord& place : removed.places)
                                                *reply.add_removed() = encode(place);
                                              reply.set_mesh_deleted(removed.mesh_deleted);
                                              return reply;
                                            });
  }
  Reply* DeleteDesign(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::DeleteDesignRequest>("DeleteDesign", Lane::Preparation, context, in, out,
                                          [](Session& session, const auto& request, const Run&) {
                                            const auto removed = session.remove_design(
                                                request.design(), request.expected());
                                            v1::DeleteDesignResponse reply;
                                            reply.set_revisions(removed.revisions);
                                            reply.set_meshes_deleted(removed.meshes_deleted);
                                            return reply;
                                          });
  }

  Reply* Compare(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::CompareRequest>(
        "Compare", Lane::Computation, context, in, out,
        [this](Session& session, const auto& request, const Run& run) {
          v1::CompareResponse reply;
          *reply.mutable_comparison() =
              encode(session.compare(decode(request.original(), "original", documents()),
                                     decode(request.modified(), "modified", documents()), run));
          return reply;
        });
  }
  Reply* ValidateModel(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::ValidateModelRequest>(
        "ValidateModel", Lane::Computation, context, in, out,
        [this](Session& session, const auto& request, const Run& run) {
          v1::ValidateModelResponse reply;
          *reply.mutable_check() = encode(located(request.document(), [&] {
            return unless_failing(
                session.validate(decode(request, documents()), decode(request.options()), run),
                request.options());
          }));
          return reply;
        });
  }
  Reply* ValidateEdit(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::ValidateEditRequest>(
        "ValidateEdit", Lane::Computation, context, in, out,
        [this](Session& session, const auto& request, const Run& run) {
          const EditToValidate what = decode(request, documents());
          v1::ValidateEditResponse reply;
          *reply.mutable_check() = encode(located(request.document(), [&] {
            return unless_failing(
                session.validate_edit(what.base, what.edit, decode(request.options()), run),
                request.options());
          }));
          return reply;
        });
  }
  Reply* ListFeatureTypes(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::ListFeatureTypesRequest>(
        "ListFeatureTypes", Lane::Metadata, context, in, out,
        [](Session& session, const auto&, const Run&) {
          v1::ListFeatureTypesResponse reply;
          for (const FeatureTypeInfo& type : session.feature_types())
            *reply.add_types() = encode(type);
          return reply;
        });
  }
  Reply* GetServerInfo(Context* context, const Bytes* in, Bytes* out) override {
    return query<v1::GetServerInfoRequest>("GetServerInfo", Lane::Metadata, context, in, out,
                                           [this](Session& session, const auto&, const Run&) {
                                             v1::GetServerInfoResponse reply;
                                             *reply.mutable_server() = server_info(
                                                 session, options_.facts, options_.limits);
                                             return reply;
                                           });
  }

 private:
  [[nodiscard]] const DocumentLimits& documents() const { return options_.limits.document; }

  std::shared_ptr<CallRecord> record(const char* method, Context* context) const {
    return std::make_shared<CallRecord>(options_.desk, method, *context);
  }

  static Validated unless_failing(Validated validated, const v1::MeshOptions& options) {
    check_warnings(validated.summary.warnings, fail_on_of(options));
    return validated;
  }

  static void describe_for(const std::shared_ptr<UnaryCall>& call, Session& session,
                           const v1::GetRevisionRequest& request) {
    const Reference reference = session.resolve(request.revision());
    const Run run{.stop = call->stop_token(), .on_progress = {}, .dumps = {}};
    call->reply(encode(session.describe(reference, run), request.documents()));
  }

  static void remake_for(const std::shared_ptr<UnaryCall>& call, Session& session,
                         const v1::RemakeRevisionRequest& request) {
    const std::string id = request.request_id();
    call->record().set_request_id(id);
    check_request_id(id);
    const auto made = [call, id](const Made& last, const std::vector<std::string>& others) {
      answering(*call, [&] {
        call->record().set_note("revision=" + last.filed.record.id.substr(0, 12));
        count_made(call->record().desk(), last);
        v1::RemakeRevisionResponse response;
        *response.mutable_result() = encode(last, id);
        for (const std::string& other : others) response.add_remade(other);
        call->reply(response);
      });
    };
    const auto failed = [call](const Error& why) { call->fail(why); };
    const MakeRequestPtr under_way = remake(session, request, made, failed);
    call->on_cancel([under_way] { under_way->cancel(); });
  }

  /// A call that makes a revision. Its request is read once there is room for its work.
  template <typename Request, typename Response>
  Reply* make(const char* method, Context* context, const Bytes* in, Bytes* out) {
    const auto record = this->record(method, context);
    Session* session = nullptr;
    Admission::TicketPtr ticket;
    Reply* refused = nullptr;
    catching(
        [&] {
          record->admit(*context);
          session = &tenants_.of(record->tenant());
          ticket = session->admit();
        },
        [&](const Error& why) { refused = refuse(*context, *record, why); });
    if (refused != nullptr) return refused;
    const auto call = UnaryCall::start(context, out, record);
    answering(*call, [&] {
      const auto id = std::make_shared<std::string>();
      // A copy of the buffer, not of its bytes: the call may be over before they are read.
      const auto read = [this, call, id, bytes = Bytes(*in)]() -> Command {
        Request request;
        from_bytes(bytes, options_.limits.message_bytes, request);
        *id = request.request_id();
        call->record().set_request_id(*id);
        check_request_id(*id);
        return decode(request, documents());
      };
      const auto made = [call, id](const Made& result) {
        answering(*call, [&] {
          call->record().set_note("revision=" + result.filed.record.id.substr(0, 12));
          count_made(call->record().desk(), result);
          Response response;
          *response.mutable_result() = encode(result, *id);
          call->reply(response);
        });
      };
      const auto failed = [call](const Error& why) { call->fail(why); };
      const MakeRequestPtr under_way = session->make(
          std::move(ticket), read, Listener{.progress = {}, .made = made, .failed = failed});
      call->on_cancel([under_way] { under_way->cancel(); });
    });
    return call.get();
  }

  template <typename Request, typename Answer>
  Reply* query(const char* method, Lane lane, Context* context, const Bytes* in, Bytes* out,
               Answer answer) {
    return answer_query<Request>(tenants_, options_, {method, lane}, context, *in, out, answer);
  }

  Tenants& tenants_;
  const ServiceOptions options_;
};

}  // namespace

std::unique_ptr<grpc::Service> make_remesh_service(Tenants& tenants, ServiceOptions options) {
  return std::make_unique<RawRemeshService>(tenants, std::move(options));
}

}  // namespace remeshd
