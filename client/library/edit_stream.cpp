// SPDX-License-Identifier: Apache-2.0
#include "remeshd/edit_stream.h"

#include <stdexcept>

#include "client/library/document_limit.h"
#include "client/library/edit_stream_impl.h"
#include "client/library/mesh_selection.h"
#include "client/library/status.h"

namespace remeshd::client {
namespace {

remesh::v1::Error stream_ended() {
  remesh::v1::Error error;
  error.set_code(remesh::v1::Error::CODE_UNAVAILABLE);
  error.set_reason(remesh::v1::Error::STREAM_ENDED);
  error.set_message("the stream ended before this request was answered");
  return error;
}

/// Answers that have come already.
EditStream::Answers failed(const remesh::v1::Error& error, std::optional<MeshWanted> mesh) {
  OpenRequest request(std::move(mesh));
  auto answers = request.answers();
  request.fail(error);
  return answers;
}

}  // namespace

EditStream::Impl::Impl(remesh::v1::RemeshService::Stub& stub, OnProgress listener,
                       const CallOptions& call, const std::string& token)
    : context(call, token),
      on_progress(std::move(listener)),
      stream(stub.EditStream(context.get())) {
  reader = std::thread([this] { read(); });
}

EditStream::Impl::~Impl() {
  if (!reader.joinable()) return;
  context.cancel();
  reader.join();
}

std::string EditStream::Impl::fresh_id() {
  const std::lock_guard lock(state);
  std::string id;
  do id = "request-" + std::to_string(next_id++);
  while (open.contains(id));
  return id;
}

EditStream::Answers EditStream::Impl::edit(remesh::v1::EditRevisionRequest request,
                                           std::optional<MeshWanted> mesh) {
  if (request.request_id().empty()) request.set_request_id(fresh_id());
  const std::string id = request.request_id();
  remesh::v1::EditStreamRequest message;
  *message.mutable_edit() = std::move(request);
  return send(id, std::move(message), std::move(mesh));
}

EditStream::Answers EditStream::Impl::create(remesh::v1::CreateRevisionRequest request,
                                             std::optional<MeshWanted> mesh) {
  if (request.request_id().empty()) request.set_request_id(fresh_id());
  const std::string id = request.request_id();
  remesh::v1::EditStreamRequest message;
  *message.mutable_create() = std::move(request);
  return send(id, std::move(message), std::move(mesh));
}

EditStream::Answers EditStream::Impl::send(const std::string& id,
                                           remesh::v1::EditStreamRequest request,
                                           std::optional<MeshWanted> mesh) {
  try {
    check_documents(request.edit());
    check_documents(request.create());
  } catch (const CallError& e) {
    return failed(e.detail(), std::move(mesh));
  }
  if (mesh) *request.mutable_mesh() = to_message(*mesh);
  const std::lock_guard one_write(writing);
  if (closed) throw std::logic_error("EditStream: nothing can be sent after finish()");
  Answers answers;
  {
    const std::lock_guard lock(state);
    if (end) return failed(*end, std::move(mesh));
    const auto [entry, added] = open.try_emplace(id, std::move(mesh));
    if (!added) throw std::invalid_argument("EditStream: request id '" + id + "' is under way");
    answers = entry->second.answers();
  }
  // A write that fails means that the stream is at its end: the reading thread answers.
  stream->Write(request);
  return answers;
}

void EditStream::Impl::take(const remesh::v1::EditStreamResponse& response) {
  if (response.has_progress()) {
    if (on_progress) on_progress(response.request_id(), response.progress());
    return;
  }
  OpenRequest* request = nullptr;
  decltype(open)::node_type ended;
  {
    const std::lock_guard lock(state);
    const auto entry = open.find(response.request_id());
    if (entry == open.end()) return;
    request = &entry->second;  // stays where it is until this thread takes it out
    // Before its future is kept: who has the answer may use the id again.
    if (request->is_last(response)) ended = open.extract(entry);
  }
  if (response.has_result()) request->take_result(response.result());
  if (response.has_mesh()) request->take_mesh(response.mesh(), last_mesh);
  if (response.has_error()) request->fail(response.error());
  if (!ended.empty()) request->fail(stream_ended());  // what the daemon left unanswered
}

void EditStream::Impl::read() {
  remesh::v1::EditStreamResponse response;
  while (stream->Read(&response)) take(response);
  const grpc::Status status = stream->Finish();
  const std::lock_guard lock(state);
  ended_well = status.ok();
  end = ended_well ? stream_ended() : error_of(status);
  for (auto& [id, request] : open) request.fail(*end);
  open.clear();
}

EditStream::EditStream(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
EditStream::EditStream(EditStream&&) noexcept = default;
EditStream& EditStream::operator=(EditStream&&) noexcept = default;
EditStream::~EditStream() = default;

std::future<remesh::v1::RevisionResult> EditStream::edit(remesh::v1::EditRevisionRequest request) {
  return impl_->edit(std::move(request), {}).result;
}

std::future<remesh::v1::RevisionResult> EditStream::create(
    remesh::v1::CreateRevisionRequest request) {
  return impl_->create(std::move(request), {}).result;
}

EditStream::Answers EditStream::edit(remesh::v1::EditRevisionRequest request, MeshWanted mesh) {
  return impl_->edit(std::move(request), std::move(mesh));
}

EditStream::Answers EditStream::create(remesh::v1::CreateRevisionRequest request, MeshWanted mesh) {
  return impl_->create(std::move(request), std::move(mesh));
}

void EditStream::cancel(const std::string& request_id) {
  remesh::v1::EditStreamRequest message;
  message.mutable_cancel()->set_request_id(request_id);
  const std::lock_guard one_write(impl_->writing);
  if (!impl_->closed) impl_->stream->Write(message);
}

void EditStream::cancel_all() { impl_->context.cancel(); }

void EditStream::finish() {
  {
    const std::lock_guard one_write(impl_->writing);
    if (!impl_->closed) impl_->stream->WritesDone();
    impl_->closed = true;
  }
  if (impl_->reader.joinable()) impl_->reader.join();
  const std::lock_guard lock(impl_->state);
  if (!impl_->ended_well) throw CallError(*impl_->end);
}

}  // namespace remeshd::client
