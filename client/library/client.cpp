// SPDX-License-Identifier: Apache-2.0
#include "remeshd/client.h"

#include <cstdint>
#include <utility>

#include "client/library/calls.h"
#include "client/library/client_impl.h"
#include "client/library/document_limit.h"
#include "client/library/edit_stream_impl.h"
#include "client/library/mesh_assembler.h"
#include "client/library/mesh_file_assembler.h"
#include "client/library/mesh_selection.h"
#include "client/library/resend.h"

namespace remeshd::client {

using Stub = Replica::Service::Stub;

namespace {

/// How far the attempts at one transfer have come. An attempt counts as progress only if it
/// received more bytes than all before it: otherwise a transfer that breaks at the same place each
/// time would be repeated for ever.
class Furthest {
 public:
  explicit Furthest(Search& search) : search_(search) {}
  void note(Replica& replica, std::uint64_t bytes) {
    if (bytes <= bytes_) return;
    bytes_ = bytes;
    search_.heard(replica);
  }

 private:
  Search& search_;
  std::uint64_t bytes_ = 0;
};

}  // namespace

Client::Client(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

remesh::v1::RevisionResult Client::create_revision(const remesh::v1::CreateRevisionRequest& request,
                                                   const CallOptions& call) const {
  check_documents(request);
  Search search = impl_->search(route_of(request), call);
  const std::string route = search.route();
  return impl_->made(call_again(std::move(search), &Stub::CreateRevision, request).result(), route);
}

remesh::v1::RevisionResult Client::edit_revision(const remesh::v1::EditRevisionRequest& request,
                                                 const CallOptions& call) const {
  check_documents(request);
  Search search = impl_->search_mesh(request.base(), call);
  const std::string route = search.route();
  remesh::v1::EditStreamRequest streamed;
  *streamed.mutable_edit() = request;
  const bool repeatable = how_to_resend(streamed, nullptr) == Resend::AsItIs;
  const auto response =
      repeatable ? call_again(std::move(search), &Stub::EditRevision, request)
                 : call_once(*impl_->farm, std::move(search), &Stub::EditRevision, request);
  return impl_->made(response.result(), route);
}

EditStream Client::stream(EditStream::OnProgress on_progress, const CallOptions& call) const {
  return EditStream(std::make_unique<EditStream::Impl>(impl_->farm, std::move(on_progress), call));
}

Mesh Client::get_mesh(const std::string& revision, const CallOptions& call,
                      const OnTransfer& on_transfer, const MeshWanted& wanted) const {
  remesh::v1::GetMeshRequest request;
  request.set_revision(revision);
  *request.mutable_selection() = to_message(wanted);
  MeshAssembler assembler(wanted.arrays, {wanted.base});
  Search search = impl_->search_mesh(revision, call);
  Furthest furthest(search);
  while (true) {
    Replica& replica = search.replica();
    CallContext context(search.rest(), replica, search.route());
    const auto reader = replica.service().GetMesh(context.get(), request);
    const auto take = [&](const remesh::v1::GetMeshResponse& response) {
      replica.reached = true;
      assembler.add(response.mesh());
      furthest.note(replica, assembler.bytes_received());
      if (on_transfer) on_transfer(assembler.bytes_received(), assembler.bytes_expected());
    };
    const grpc::Status status = read_all(*reader, context, take);
    if (status.ok() || assembler.ended()) return assembler.finish();
    if (!search.goes_on(replica, status)) check(status);
    if (const auto position = assembler.resume()) *request.mutable_resume_from() = *position;
  }
}

std::string Client::get_mesh_file(const std::string& revision, const std::string& format,
                                  const CallOptions& call, const OnTransfer& on_transfer) const {
  remesh::v1::GetMeshFileRequest request;
  request.set_revision(revision);
  request.set_format(format);
  MeshFileAssembler assembler;
  Search search = impl_->search_mesh(revision, call);
  Furthest furthest(search);
  while (true) {
    Replica& replica = search.replica();
    CallContext context(search.rest(), replica, search.route());
    const auto reader = replica.service().GetMeshFile(context.get(), request);
    const auto take = [&](const remesh::v1::GetMeshFileResponse& response) {
      replica.reached = true;
      assembler.add(response);
      furthest.note(replica, assembler.bytes_received());
      if (on_transfer) on_transfer(assembler.bytes_received(), assembler.bytes_expected());
    };
    const grpc::Status status = read_all(*reader, context, take);
    if (status.ok()) return assembler.finish();
    if (!search.goes_on(replica, status)) check(status);
    assembler.restart();
  }
}

remesh::v1::GetRevisionResponse Client::get_revision(const std::string& revision,
                                                     const CallOptions& call) const {
  remesh::v1::GetRevisionRequest request;
  request.set_revision(revision);
  auto reply = call_again(impl_->search_for(revision, call), &Stub::GetRevision, request);
  const auto& found = reply.revision();
  impl_->farm->remember_route(
      found.id(), call.route.value_or(found.design().empty() ? found.root() : found.design()));
  return reply;
}

std::vector<remesh::v1::RevisionInfo> Client::list_revisions(
    remesh::v1::ListRevisionsRequest request, const CallOptions& call) const {
  const std::string route = request.filter().design();
  return all_pages(impl_->search(route, call), &Stub::ListRevisions, std::move(request),
                   &remesh::v1::ListRevisionsResponse::revisions);
}

std::vector<remesh::v1::RevisionInfo> Client::log(const std::string& design,
                                                  const CallOptions& call) const {
  remesh::v1::ListRevisionsRequest request;
  request.mutable_filter()->set_design(design);
  return list_revisions(std::move(request), call);
}

std::vector<remesh::v1::DesignInfo> Client::list_designs(remesh::v1::ListDesignsRequest request,
                                                         const CallOptions& call) const {
  return all_pages(impl_->search("", call), &Stub::ListDesigns, std::move(request),
                   &remesh::v1::ListDesignsResponse::designs);
}

remesh::v1::SetHeadResponse Client::set_head(const remesh::v1::SetHeadRequest& request,
                                             const CallOptions& call) const {
  const std::string& of = request.design().empty() ? request.revision() : request.design();
  return call_once(*impl_->farm, impl_->search_for(of, call), &Stub::SetHead, request);
}

remesh::v1::DeleteRevisionResponse Client::delete_revision(const std::string& revision,
                                                           bool allow_head,
                                                           const CallOptions& call) const {
  remesh::v1::DeleteRevisionRequest request;
  request.set_revision(revision);
  request.set_allow_head(allow_head);
  return call_once(*impl_->farm, impl_->search_for(revision, call), &Stub::DeleteRevision, request);
}

remesh::v1::DeleteDesignResponse Client::delete_design(
    const remesh::v1::DeleteDesignRequest& request, const CallOptions& call) const {
  return call_once(*impl_->farm, impl_->search(request.design(), call), &Stub::DeleteDesign,
                   request);
}

remesh::v1::Comparison Client::compare(const remesh::v1::CompareRequest& request,
                                       const CallOptions& call) const {
  check_documents(request);
  Search search = impl_->search_for(request.original().revision(), call);
  return call_again(std::move(search), &Stub::Compare, request).comparison();
}

remesh::v1::ModelCheck Client::validate(const remesh::v1::ValidateModelRequest& request,
                                        const CallOptions& call) const {
  check_documents(request);
  return call_again(impl_->search("", call), &Stub::ValidateModel, request).check();
}

remesh::v1::ModelCheck Client::validate(const remesh::v1::ValidateEditRequest& request,
                                        const CallOptions& call) const {
  check_documents(request);
  return call_again(impl_->search_for(request.base(), call), &Stub::ValidateEdit, request).check();
}

std::vector<remesh::v1::FeatureType> Client::types(const CallOptions& call) const {
  const auto reply = call_again(impl_->search("", call), &Stub::ListFeatureTypes, {});
  return {reply.types().begin(), reply.types().end()};
}

remesh::v1::ServerInfo Client::info(const CallOptions& call) const {
  return call_again(impl_->search("", call), &Stub::GetServerInfo, {}).server();
}

remesh::v1::GetRecipeResponse Client::get_recipe(const std::string& revision,
                                                 const CallOptions& call) const {
  remesh::v1::GetRecipeRequest request;
  request.set_revision(revision);
  return call_again(impl_->search_for(revision, call), &Stub::GetRecipe, request);
}

remesh::v1::RemakeRevisionResponse Client::remake_revision(
    const remesh::v1::RemakeRevisionRequest& request, const CallOptions& call) const {
  const std::string& of = request.design().empty() ? request.revision() : request.design();
  return call_once(*impl_->farm, impl_->search_for(of, call), &Stub::RemakeRevision, request);
}

}  // namespace remeshd::client
