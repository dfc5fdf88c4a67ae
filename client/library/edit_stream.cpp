// SPDX-License-Identifier: Apache-2.0
#include "remeshd/edit_stream.h"

#include <algorithm>
#include <stdexcept>

#include "client/library/document_limit.h"
#include "client/library/edit_stream_impl.h"
#include "client/library/mesh_selection.h"
#include "client/library/resend.h"
#include "client/library/routes.h"
#include "client/library/status.h"
#include "client/library/stream_errors.h"

namespace remeshd::client {
namespace {

using remesh::v1::Error;

/// Answers whose futures throw the error.
EditStream::Answers failed(const Error& error, std::optional<MeshWanted> mesh) {
  OpenRequest request(std::move(mesh));
  auto answers = request.answers();
  request.fail(error);
  return answers;
}

}  // namespace

EditStream::Impl::Impl(std::shared_ptr<Farm> farm, OnProgress listener, const CallOptions& call)
    : farm_(std::move(farm)), on_progress_(std::move(listener)), options_(call) {}

EditStream::Impl::~Impl() {
  if (!reader_.joinable()) return;
  cancel_all();
  reader_.join();
}

CallOptions EditStream::Impl::rest() const {
  CallOptions rest = options_;
  if (rest.timeout)
    *rest.timeout -=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  return rest;
}

/// The route of the stream; may look up the base of the first edit (GetRevision).
std::string EditStream::Impl::route_of_first(const remesh::v1::EditStreamRequest& first) const {
  if (options_.route) return *options_.route;
  if (first.has_create()) return route_of(first.create());
  const std::string& base = first.edit().base();
  return looked_up_route(farm_, base.empty() ? first.edit().design() : base, rest());
}

/// Pre: under `writing_`.
void EditStream::Impl::open(const remesh::v1::EditStreamRequest& first) {
  {
    const std::lock_guard lock(state_);
    if (search_ || cancelled_ || closed_) return;
  }
  auto search = std::make_unique<Search>(farm_, route_of_first(first), rest());
  const std::lock_guard lock(state_);
  if (cancelled_) return;
  search_ = std::move(search);
  call_ = std::make_shared<Call>(*search_);
  reader_ = std::thread([this] { read(); });
}

EditStream::Impl::Requests::iterator EditStream::Impl::find(const std::string& id) {
  return std::ranges::find(unanswered_, id, &Unanswered::id);
}

std::string EditStream::Impl::fresh_id() {
  const std::lock_guard lock(state_);
  std::string id;
  do id = "request-" + std::to_string(next_id_++);
  while (find(id) != unanswered_.end());
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
  const std::lock_guard one_write(writing_);
  try {
    check_documents(request.edit());
    check_documents(request.create());
    open(request);
  } catch (const CallError& e) {
    return failed(e.detail(), std::move(mesh));
  }
  if (mesh) *request.mutable_mesh() = to_message(*mesh);
  Answers answers;
  {
    const std::lock_guard lock(state_);
    if (closed_) throw std::logic_error("EditStream: nothing can be sent after finish()");
    if (end_) return failed(*end_, std::move(mesh));
    if (!call_) return failed(request_cancelled(), std::move(mesh));
    if (find(id) != unanswered_.end())
      throw std::invalid_argument("EditStream: request id '" + id + "' is under way");
    unanswered_.push_back({id, std::move(request), OpenRequest(std::move(mesh))});
    answers = unanswered_.back().request.answers();
  }
  send_waiting();
  return answers;
}

/// The message of a request that waits to be sent; nothing where it has to wait for those before
/// it. Pre: under `state_`; all before it have been sent.
std::optional<remesh::v1::EditStreamRequest> EditStream::Impl::to_send(const Unanswered& next) {
  const bool first = &next == &unanswered_.front();
  if (next.sent_before) {
    if (how_to_resend(next.message, last_ ? &*last_ : nullptr) == Resend::AsItIs)
      return last_ ? in_design_of_last(next.message, *last_) : next.message;
    if (!first) return std::nullopt;  // the result before it has not come yet
    return on_last(next.message, *last_);
  }
  // In a new call the daemon does not know the last result, the base of an edit that names none.
  if (call_->used || !last_) return next.message;
  const bool follows = next.message.has_edit() && next.message.edit().base().empty() &&
                       next.message.edit().design().empty();
  if (!follows) return in_design_of_last(next.message, *last_);
  remesh::v1::EditStreamRequest message = next.message;
  const auto& revision = last_->revision();
  message.mutable_edit()->set_base(revision.design().empty() ? revision.id() : revision.design());
  return message;
}

/// Whether the first unanswered request cannot be sent a second time. Pre: under `state_`.
bool EditStream::Impl::first_is_lost() const {
  if (unanswered_.empty()) return false;
  const Unanswered& first = unanswered_.front();
  return first.sent_before && !first.sent &&
         how_to_resend(first.message, last_ ? &*last_ : nullptr) == Resend::Impossible;
}

/// Pre: under `writing_`.
void EditStream::Impl::send_waiting() {
  while (true) {
    std::shared_ptr<Call> to;
    std::optional<remesh::v1::EditStreamRequest> message;
    Requests lost;
    {
      const std::lock_guard lock(state_);
      to = call_;
      const auto next = std::ranges::find(unanswered_, false, &Unanswered::sent);
      if (first_is_lost()) {
        lost.splice(lost.end(), unanswered_, unanswered_.begin());
      } else if (next == unanswered_.end()) {
        if (!closed_ || to->writes_done) return;
        to->writes_done = true;
      } else {
        message = to_send(*next);
        if (!message) return;
        next->sent = true;
        to->used = true;
      }
    }
    if (!lost.empty()) {
      lost.front().request.fail(not_sent_again());
      continue;
    }
    // A write that fails means that the call is at its end: the reading thread sees to it.
    if (!message) {
      to->stream->WritesDone();
      return;
    }
    to->stream->Write(*message);
  }
}

/// Whether a response makes the whole stream move to another replica. It does if it is an error of
/// the first unanswered request, by which the request was not carried out, and which another
/// replica may not give. All unanswered requests move along, so that their order stays.
bool EditStream::Impl::moves_on(Call& from, const remesh::v1::EditStreamResponse& response) {
  if (!response.has_error()) return false;
  {
    const std::lock_guard lock(state_);
    if (cancelled_ || unanswered_.empty() || unanswered_.front().id != response.request_id() ||
        unanswered_.front().result)
      return false;
  }
  return search_->goes_on(from.replica, response.error());
}

void EditStream::Impl::take(Call& from, const remesh::v1::EditStreamResponse& response) {
  from.replica.reached = true;
  if (response.has_progress()) {
    if (on_progress_) on_progress_(response.request_id(), response.progress());
    return;
  }
  OpenRequest* request = nullptr;
  Requests done;
  {
    const std::lock_guard lock(state_);
    const auto entry = find(response.request_id());
    if (entry == unanswered_.end()) return;
    request = &entry->request;  // stays where it is until this thread takes it out
    if (response.has_result()) {
      entry->result = response.result();
      farm_->remember_route(response.result().revision().id(), search_->route());
    }
    // Taken out before its promise is kept: whoever has the answer may use the id again.
    if (request->is_last(response)) {
      if (entry->result) last_ = entry->result;
      search_->heard(from.replica);
      done.splice(done.begin(), unanswered_, entry);
    }
  }
  if (response.has_result()) request->take_result(response.result());
  if (response.has_mesh()) request->take_mesh(response.mesh(), last_mesh_);
  if (response.has_error()) request->fail(response.error());
  if (done.empty()) return;
  request->fail(stream_ended());  // what the daemon left unanswered
  bool waiting = false;
  {
    const std::lock_guard lock(state_);
    waiting = !unanswered_.empty() && !unanswered_.back().sent;
  }
  if (!waiting) return;
  const std::lock_guard one_write(writing_);
  send_waiting();
}

bool EditStream::Impl::is_over() {
  const std::lock_guard lock(state_);
  return cancelled_ || (closed_ && unanswered_.empty());
}

/// Takes out the requests that are cancelled: where their call has broken, the daemon may not have
/// heard of it. Pre: under `state_`.
EditStream::Impl::Requests EditStream::Impl::take_cancelled() {
  Requests taken;
  for (auto next = unanswered_.begin(); next != unanswered_.end();) {
    const auto entry = next++;
    if (!entry->cancelled) continue;
    if (entry->result) last_ = entry->result;  // only its mesh is cancelled
    taken.splice(taken.end(), unanswered_, entry);
  }
  return taken;
}

/// Opens the stream again at the replica that `search_` names, and sends what is unanswered again,
/// but for what is cancelled; false where the stream was cancelled. `refused`: the first request
/// was refused, so it was not carried out.
bool EditStream::Impl::reopen(bool refused) {
  Requests not_wanted;
  const std::lock_guard one_write(writing_);
  {
    const std::lock_guard lock(state_);
    if (cancelled_) return false;
    // The first may be among them: what is the first from now on was not refused.
    refused = refused && !unanswered_.front().cancelled;
    not_wanted = take_cancelled();
    for (Unanswered& entry : unanswered_) {
      const bool not_done = !entry.sent || (refused && &entry == &unanswered_.front());
      entry.sent_before = entry.sent_before || !not_done;
      entry.sent = false;
      entry.request.restart();
    }
    call_ = std::make_shared<Call>(*search_);
  }
  for (Unanswered& entry : not_wanted) entry.request.fail(request_cancelled());
  send_waiting();
  return true;
}

void EditStream::Impl::end_with(const grpc::Status& status) {
  Requests open;
  Error error;
  {
    const std::lock_guard lock(state_);
    // Nothing is lost where it broke after the last answer.
    ended_well_ =
        unanswered_.empty() && (status.ok() || (is_broken(status) && !cancelled_ && closed_));
    if (cancelled_)
      error = request_cancelled();
    else
      error = status.ok() || ended_well_ ? stream_ended() : error_of(status);
    end_ = error;
    open.swap(unanswered_);
  }
  for (Unanswered& entry : open) entry.request.fail(error);
}

void EditStream::Impl::read() {
  while (true) {
    std::shared_ptr<Call> from;
    {
      const std::lock_guard lock(state_);
      from = call_;
    }
    remesh::v1::EditStreamResponse response;
    bool refused = false;
    while (!refused && from->stream->Read(&response)) {
      refused = moves_on(*from, response);
      if (!refused) take(*from, response);
    }
    if (refused) from->context.cancel();
    const grpc::Status status = from->stream->Finish();
    const bool goes_on =
        refused || (!is_over() && search_->goes_on(from->replica, broken_by(status)));
    if (!goes_on || !reopen(refused)) return end_with(status);
  }
}

void EditStream::Impl::cancel(const std::string& request_id) {
  remesh::v1::EditStreamRequest message;
  message.mutable_cancel()->set_request_id(request_id);
  Requests unsent;
  const std::lock_guard one_write(writing_);
  std::shared_ptr<Call> to;
  {
    const std::lock_guard lock(state_);
    if (closed_ || !call_) return;
    to = call_;
    const auto entry = find(request_id);
    if (entry != unanswered_.end()) {
      entry->cancelled = true;
      if (!entry->sent) unsent.splice(unsent.begin(), unanswered_, entry);
    }
  }
  if (unsent.empty()) {
    to->stream->Write(message);
  } else {
    unsent.front().request.fail(request_cancelled());
  }
}

void EditStream::Impl::cancel_all() {
  const std::lock_guard lock(state_);
  cancelled_ = true;
  if (!call_) return;
  search_->stop();
  call_->context.cancel();
}

void EditStream::Impl::finish() {
  {
    const std::lock_guard one_write(writing_);
    {
      const std::lock_guard lock(state_);
      closed_ = true;
      if (!call_) return;  // nothing was sent
    }
    send_waiting();
  }
  if (reader_.joinable()) reader_.join();
  const std::lock_guard lock(state_);
  if (!ended_well_) throw CallError(*end_);
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

void EditStream::cancel(const std::string& request_id) { impl_->cancel(request_id); }
void EditStream::cancel_all() { impl_->cancel_all(); }
void EditStream::finish() { impl_->finish(); }

}  // namespace remeshd::client
