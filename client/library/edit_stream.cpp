// SPDX-License-Identifier: Apache-2.0
#include "remeshd/edit_stream.h"

#include <stdexcept>

#include "client/library/edit_stream_impl.h"
#include "client/library/status.h"

namespace remeshd::client {
namespace {

remesh::v1::Error stream_ended() {
  remesh::v1::Error error;
  error.set_code(remesh::v1::Error::UNAVAILABLE);
  error.set_reason("StreamEnded");
  error.set_message("the stream ended before this request was answered");
  return error;
}

}  // namespace

EditStream::Impl::Impl(remesh::v1::Remesh::Stub& stub, OnProgress listener, const CallOptions& call)
    : context(call), on_progress(std::move(listener)), stream(stub.EditStream(context.get())) {
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

std::future<remesh::v1::RevisionReply> EditStream::Impl::send(
    const std::string& id, const remesh::v1::EditStreamRequest& request) {
  const std::lock_guard one_write(writing);
  if (closed) throw std::logic_error("EditStream: nothing can be sent after finish()");
  std::future<remesh::v1::RevisionReply> answer;
  {
    const std::lock_guard lock(state);
    const auto [entry, added] = open.try_emplace(id);
    if (!added) throw std::invalid_argument("EditStream: request id '" + id + "' is under way");
    answer = entry->second.get_future();
    if (end) {
      entry->second.set_exception(std::make_exception_ptr(CallError(*end)));
      open.erase(entry);
      return answer;
    }
  }
  // A write that fails means that the stream is at its end: the reading thread answers.
  stream->Write(request);
  return answer;
}

void EditStream::Impl::read() {
  remesh::v1::EditStreamReply reply;
  while (stream->Read(&reply)) {
    if (reply.has_progress()) {
      if (on_progress) on_progress(reply.request_id(), reply.progress());
      continue;
    }
    std::promise<remesh::v1::RevisionReply> promise;
    {
      const std::lock_guard lock(state);
      const auto entry = open.find(reply.request_id());
      if (entry == open.end()) continue;
      promise = std::move(entry->second);
      open.erase(entry);
    }
    if (reply.has_revision())
      promise.set_value(reply.revision());
    else
      promise.set_exception(std::make_exception_ptr(CallError(reply.error())));
  }
  const grpc::Status status = stream->Finish();
  const std::lock_guard lock(state);
  ended_well = status.ok();
  end = ended_well ? stream_ended() : error_of(status);
  for (auto& [id, promise] : open) promise.set_exception(std::make_exception_ptr(CallError(*end)));
  open.clear();
}

EditStream::EditStream(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
EditStream::EditStream(EditStream&&) noexcept = default;
EditStream& EditStream::operator=(EditStream&&) noexcept = default;
EditStream::~EditStream() = default;

std::future<remesh::v1::RevisionReply> EditStream::edit(remesh::v1::EditRevisionRequest request) {
  if (request.request_id().empty()) request.set_request_id(impl_->fresh_id());
  const std::string id = request.request_id();
  remesh::v1::EditStreamRequest message;
  *message.mutable_edit() = std::move(request);
  return impl_->send(id, message);
}

std::future<remesh::v1::RevisionReply> EditStream::create(
    remesh::v1::CreateRevisionRequest request) {
  if (request.request_id().empty()) request.set_request_id(impl_->fresh_id());
  const std::string id = request.request_id();
  remesh::v1::EditStreamRequest message;
  *message.mutable_create() = std::move(request);
  return impl_->send(id, message);
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
