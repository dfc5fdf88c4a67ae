// SPDX-License-Identifier: Apache-2.0
#include "remeshd/client.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/support/channel_arguments.h>

#include <utility>

#include "remesh/v1/cache.grpc.pb.h"

#include "client/library/call_context.h"
#include "client/library/document_limit.h"
#include "client/library/edit_stream_impl.h"
#include "client/library/mesh_assembler.h"
#include "client/library/mesh_file_assembler.h"
#include "client/library/mesh_selection.h"
#include "client/library/reconnecting.h"
#include "client/library/status.h"

namespace remeshd::client {
namespace {

using remesh::v1::RemeshService;
using Stub = RemeshService::Stub;
using CacheStub = remesh::v1::CacheService::Stub;

/// Lists and models are the largest single messages; meshes come in parts of at most 1 MiB.
constexpr int kMaxMessage = 256 << 20;
/// ms; also TCP_USER_TIMEOUT, which at 1 s cuts slow but live readers.
constexpr int kKeepaliveTimeout = 20'000;

template <class Service, class Request, class Reply>
using Method = grpc::Status (Service::*)(grpc::ClientContext*, const Request&, Reply*);

template <class Service, class Request, class Reply>
grpc::Status ask(const auto& impl, Method<Service, Request, Reply> method, const Request& request,
                 const CallOptions& options, Reply& reply) {
  CallContext context(options, impl.token);
  return (impl.of(static_cast<const Service*>(nullptr)).*method)(context.get(), request, &reply);
}

/// `impl`: of the client. The method is that of one of its stubs, and changes something: it is not
/// made again where the connection breaks, since it may have been done.
template <class Service, class Request, class Reply>
Reply unary(const auto& impl, Method<Service, Request, Reply> method, const Request& request,
            const CallOptions& options) {
  Reply reply;
  check(ask(impl, method, request, options, reply));
  *impl.answered = true;
  return reply;
}

/// The same of a method that changes nothing: made again where the connection breaks.
template <class Service, class Request, class Reply>
Reply read(const auto& impl, Method<Service, Request, Reply> method, const Request& request,
           const CallOptions& options) {
  Reconnecting patience(options, impl.answered);
  while (true) {
    Reply reply;
    const grpc::Status status = ask(impl, method, request, patience.rest(), reply);
    if (!status.ok() && patience.tries_again(status)) continue;
    check(status);
    patience.heard();
    return reply;
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

bool encrypts(const ConnectOptions& options) {
  return !options.root_certificates.empty() || !options.certificate.empty();
}

std::shared_ptr<grpc::ChannelCredentials> credentials(const ConnectOptions& options) {
  if (!encrypts(options)) return grpc::InsecureChannelCredentials();
  grpc::SslCredentialsOptions tls;
  tls.pem_root_certs = options.root_certificates;
  tls.pem_cert_chain = options.certificate;
  tls.pem_private_key = options.private_key;
  return grpc::SslCredentials(tls);
}

/// gRPC would ask a proxy of the environment even for the way to this machine.
bool is_loopback(const std::string& address) {
  return address.starts_with("127.") || address.starts_with("localhost:") ||
         address.starts_with("[::1]:");
}

/// A token is as good as a password: it goes where nobody can read it on its way.
void check_token(const std::string& address, const ConnectOptions& options) {
  if (options.token.empty() || encrypts(options)) return;
  if (is_loopback(address) || address.starts_with("unix:")) return;
  remesh::v1::Error error;
  error.set_code(remesh::v1::Error::CODE_INVALID_ARGUMENT);
  error.set_stage("request");
  error.set_parameter("token");
  error.set_message("a token would be sent to " + address + " for anyone to read");
  error.set_hint("use TLS: root_certificates; of `remesh`: --tls-ca FILE");
  throw CallError(std::move(error));
}

}  // namespace

struct Client::Impl {
  explicit Impl(const std::shared_ptr<grpc::Channel>& channel, std::string token_to_send = {})
      : stub(RemeshService::NewStub(channel)),
        cache(remesh::v1::CacheService::NewStub(channel)),
        token(std::move(token_to_send)) {}
  /// The stub that has the method.
  Stub& of(const Stub* /*service*/) const { return *stub; }
  CacheStub& of(const CacheStub* /*service*/) const { return *cache; }

  const std::shared_ptr<Stub> stub;
  const std::unique_ptr<CacheStub> cache;
  const std::string token;
  const Answered answered = std::make_shared<std::atomic<bool>>(false);
};

Client Client::connect(const std::string& address, const ConnectOptions& options) {
  check_token(address, options);
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, options.keepalive * 1000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, kKeepaliveTimeout);
  arguments.SetMaxReceiveMessageSize(kMaxMessage);
  if (is_loopback(address)) arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  return Client(std::make_shared<const Impl>(
      grpc::CreateCustomChannel(address, credentials(options), arguments), options.token));
}

Client::Client(std::shared_ptr<grpc::Channel> channel)
    : Client(std::make_shared<const Impl>(channel)) {}

Client::Client(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

remesh::v1::RevisionResult Client::create_revision(const remesh::v1::CreateRevisionRequest& request,
                                                   const CallOptions& call) const {
  check_documents(request);
  return unary(*impl_, &Stub::CreateRevision, request, call).result();
}

remesh::v1::RevisionResult Client::edit_revision(const remesh::v1::EditRevisionRequest& request,
                                                 const CallOptions& call) const {
  check_documents(request);
  return unary(*impl_, &Stub::EditRevision, request, call).result();
}

EditStream Client::stream(EditStream::OnProgress on_progress, const CallOptions& call) const {
  return EditStream(std::make_unique<EditStream::Impl>(impl_->stub, std::move(on_progress), call,
                                                       impl_->token, impl_->answered));
}

Mesh Client::get_mesh(const std::string& revision, const CallOptions& call,
                      const OnTransfer& on_transfer, const MeshWanted& wanted) const {
  remesh::v1::GetMeshRequest request;
  request.set_revision(revision);
  *request.mutable_selection() = to_message(wanted);
  MeshAssembler assembler(wanted.arrays, {wanted.base});
  Reconnecting patience(call, impl_->answered);
  while (true) {
    CallContext context(patience.rest(), impl_->token);
    const auto reader = impl_->stub->GetMesh(context.get(), request);
    const auto take = [&](const remesh::v1::GetMeshResponse& response) {
      patience.heard();
      assembler.add(response.mesh());
      if (on_transfer) on_transfer(assembler.bytes_received(), assembler.bytes_expected());
    };
    const grpc::Status status = read_all(*reader, context, take);
    if (status.ok()) return assembler.finish();
    if (!patience.tries_again(status)) check(status);
    if (const auto position = assembler.resume()) *request.mutable_resume_from() = *position;
  }
}

std::string Client::get_mesh_file(const std::string& revision, const std::string& format,
                                  const CallOptions& call, const OnTransfer& on_transfer) const {
  remesh::v1::GetMeshFileRequest request;
  request.set_revision(revision);
  request.set_format(format);
  MeshFileAssembler assembler;
  Reconnecting patience(call, impl_->answered);
  while (true) {
    CallContext context(patience.rest(), impl_->token);
    const auto reader = impl_->stub->GetMeshFile(context.get(), request);
    const auto take = [&](const remesh::v1::GetMeshFileResponse& response) {
      patience.heard();
      assembler.add(response);
      if (on_transfer) on_transfer(assembler.bytes_received(), assembler.bytes_expected());
    };
    const grpc::Status status = read_all(*reader, context, take);
    if (status.ok()) return assembler.finish();
    if (!patience.tries_again(status)) check(status);
    assembler.restart();
  }
}

remesh::v1::GetRevisionResponse Client::get_revision(const std::string& revision,
                                                     const CallOptions& call) const {
  remesh::v1::GetRevisionRequest request;
  request.set_revision(revision);
  return read(*impl_, &Stub::GetRevision, request, call);
}

std::vector<remesh::v1::RevisionInfo> Client::list_revisions(
    remesh::v1::ListRevisionsRequest request, const CallOptions& call) const {
  std::vector<remesh::v1::RevisionInfo> revisions;
  request.clear_page_token();
  do {
    const auto page = read(*impl_, &Stub::ListRevisions, request, call);
    revisions.insert(revisions.end(), page.revisions().begin(), page.revisions().end());
    request.set_page_token(page.next_page_token());
  } while (!request.page_token().empty());
  return revisions;
}

std::vector<remesh::v1::RevisionInfo> Client::log(const std::string& design,
                                                  const CallOptions& call) const {
  remesh::v1::ListRevisionsRequest request;
  request.mutable_filter()->set_design(design);
  return list_revisions(std::move(request), call);
}

std::vector<remesh::v1::DesignInfo> Client::list_designs(remesh::v1::ListDesignsRequest request,
                                                         const CallOptions& call) const {
  std::vector<remesh::v1::DesignInfo> designs;
  request.clear_page_token();
  do {
    const auto page = read(*impl_, &Stub::ListDesigns, request, call);
    designs.insert(designs.end(), page.designs().begin(), page.designs().end());
    request.set_page_token(page.next_page_token());
  } while (!request.page_token().empty());
  return designs;
}

remesh::v1::SetHeadResponse Client::set_head(const remesh::v1::SetHeadRequest& request,
                                             const CallOptions& call) const {
  return unary(*impl_, &Stub::SetHead, request, call);
}

remesh::v1::DeleteRevisionResponse Client::delete_revision(const std::string& revision,
                                                           bool allow_head,
                                                           const CallOptions& call) const {
  remesh::v1::DeleteRevisionRequest request;
  request.set_revision(revision);
  request.set_allow_head(allow_head);
  return unary(*impl_, &Stub::DeleteRevision, request, call);
}

remesh::v1::DeleteDesignResponse Client::delete_design(
    const remesh::v1::DeleteDesignRequest& request, const CallOptions& call) const {
  return unary(*impl_, &Stub::DeleteDesign, request, call);
}

remesh::v1::Comparison Client::compare(const remesh::v1::CompareRequest& request,
                                       const CallOptions& call) const {
  check_documents(request);
  return read(*impl_, &Stub::Compare, request, call).comparison();
}

remesh::v1::ModelCheck Client::validate(const remesh::v1::ValidateModelRequest& request,
                                        const CallOptions& call) const {
  check_documents(request);
  return read(*impl_, &Stub::ValidateModel, request, call).check();
}

remesh::v1::ModelCheck Client::validate(const remesh::v1::ValidateEditRequest& request,
                                        const CallOptions& call) const {
  check_documents(request);
  return read(*impl_, &Stub::ValidateEdit, request, call).check();
}

std::vector<remesh::v1::FeatureType> Client::types(const CallOptions& call) const {
  const auto reply = read(*impl_, &Stub::ListFeatureTypes, {}, call);
  return {reply.types().begin(), reply.types().end()};
}

remesh::v1::ServerInfo Client::info(const CallOptions& call) const {
  return read(*impl_, &Stub::GetServerInfo, {}, call).server();
}

remesh::v1::GetRecipeResponse Client::get_recipe(const std::string& revision,
                                                 const CallOptions& call) const {
  remesh::v1::GetRecipeRequest request;
  request.set_revision(revision);
  return read(*impl_, &Stub::GetRecipe, request, call);
}

remesh::v1::RemakeRevisionResponse Client::remake_revision(
    const remesh::v1::RemakeRevisionRequest& request, const CallOptions& call) const {
  return unary(*impl_, &Stub::RemakeRevision, request, call);
}

std::vector<remesh::v1::CacheEntry> Client::list_cache(remesh::v1::ListCacheEntriesRequest request,
                                                       const CallOptions& call) const {
  std::vector<remesh::v1::CacheEntry> entries;
  request.clear_page_token();
  do {
    const auto page = read(*impl_, &CacheStub::ListCacheEntries, request, call);
    entries.insert(entries.end(), page.entries().begin(), page.entries().end());
    request.set_page_token(page.next_page_token());
  } while (!request.page_token().empty());
  return entries;
}

remesh::v1::GetCacheStatsResponse Client::cache_stats(const CallOptions& call) const {
  return read(*impl_, &CacheStub::GetCacheStats, {}, call);
}

remesh::v1::CollectGarbageResponse Client::collect_garbage(
    const remesh::v1::CollectGarbageRequest& request, const CallOptions& call) const {
  return unary(*impl_, &CacheStub::CollectGarbage, request, call);
}

remesh::v1::VerifyCacheResponse Client::verify_cache(
    bool repair, const std::function<void(const remesh::v1::VerifyCacheResponse&)>& on_message,
    const CallOptions& call) const {
  CallContext context(call, impl_->token);
  remesh::v1::VerifyCacheRequest request;
  request.set_repair(repair);
  const auto reader = impl_->cache->VerifyCache(context.get(), request);
  remesh::v1::VerifyCacheResponse message;
  while (reader->Read(&message)) on_message(message);
  check(reader->Finish());
  return message;
}

remesh::v1::CacheEntry Client::set_pin(const std::string& revision, bool pinned,
                                       const CallOptions& call) const {
  remesh::v1::SetPinRequest request;
  request.set_revision(revision);
  request.set_pinned(pinned);
  return unary(*impl_, &CacheStub::SetPin, request, call).entry();
}

}  // namespace remeshd::client
