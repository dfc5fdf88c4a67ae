#include "server/service/edit_stream.h"

#include <new>
#include <utility>

#include "server/service/count_made.h"
#include "server/service/decode.h"
#include "server/service/encode.h"
#include "server/service/mesh_messages.h"
#include "server/service/refused_call.h"
#include "server/service/request_id.h"
#include "server/service/status.h"
#include "server/service/stream_request.h"
#include "server/service/streamed_mesh.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

/// A copy, since the buffer's slices may keep much larger blocks of the connection in memory.
std::string copy_of(const grpc::ByteBuffer& bytes) {
  std::vector<grpc::Slice> slices;
  std::string copy;
  if (!bytes.Dump(&slices).ok()) return copy;
  copy.reserve(bytes.Length());
  for (const grpc::Slice& slice : slices)
    copy.append(reinterpret_cast<const char*>(slice.begin()), slice.size());
  return copy;
}

void release(std::string& bytes) { std::string().swap(bytes); }

}  // namespace

EditStream::EditStream(Session& session, const RequestLimits& limits,
                       grpc::CallbackServerContext* context, std::shared_ptr<CallRecord> record,
                       MemoryBudget::Lease memory)
    : session_(session),
      limits_(limits),
      context_(context),
      record_(std::move(record)),
      queue_(std::move(memory)) {}

grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>* EditStream::start(
    Tenants& tenants, const RequestLimits& limits, grpc::CallbackServerContext* context,
    std::shared_ptr<CallRecord> record) {
  using Refused = RefusedCall<grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>>;
  Session* session = nullptr;
  MemoryBudget::Lease memory;
  try {
    record->admit_stream(*context);
    session = &tenants.of(record->tenant());
    static_cast<void>(record->enter());
    memory = session->take_stream_memory();
    record->count_as_stream();
  } catch (const Error& why) {
    return new Refused(context, why, std::move(record));
  }
  const auto stream =
      std::make_shared<EditStream>(*session, limits, context, std::move(record), std::move(memory));
  stream->self_ = stream;
  stream->advance();
  return stream.get();
}

template <typename Work>
void EditStream::safely(Work&& work) noexcept {
  try {
    work();
  } catch (const std::bad_alloc&) {
    close(out_of_memory_status());
  } catch (...) {
    close({grpc::StatusCode::INTERNAL, ""});
  }
}

template <typename Work>
void EditStream::answering(std::uint64_t turn, Work&& work) noexcept {
  bool answered = false;
  safely([&] {
    work();
    answered = true;
  });
  if (answered) return;
  {
    const std::scoped_lock lock(mutex_);
    queue_.answer(turn, {});  // `safely` has closed the queue: it keeps no reply
    request_ = nullptr;
    pass_.reset();
  }
  advance();
}

void EditStream::OnReadDone(bool ok) {
  const auto self = shared_from_this();
  if (ok) safely([&] { take(); });
  {
    const std::scoped_lock lock(mutex_);
    reading_ = false;
    if (!ok) reads_done_ = true;
  }
  advance();
}

void EditStream::take() {
  Request request;
  bool waits = true;
  catching([&] { waits = read(request); },
           [&](const Error& why) {
             release(request.bytes);
             request.refused = why;
           });
  incoming_.Clear();
  if (!waits) return;
  const std::scoped_lock lock(mutex_);
  queue_.add(std::move(request));
}

bool EditStream::read(Request& request) {
  request.bytes = copy_of(incoming_);
  const StreamRequestHead head = read_head(request.bytes);
  request.id = echoed_request_id(head.request_id);
  check_size(request.bytes.size(), limits_.message_bytes);
  check_request_id(head.request_id);
  if (!head.is_cancel) {
    const std::scoped_lock lock(mutex_);
    if (!queue_.make_room(request.bytes.size())) throw session_.no_memory();
    return true;
  }
  v1::EditStreamRequest message;
  from_bytes(request.bytes, limits_.message_bytes, message);
  cancel_by_id(message.cancel().request_id());
  return false;
}

void EditStream::cancel_by_id(const std::string& id) {
  MakeRequestPtr request;
  {
    const std::scoped_lock lock(mutex_);
    if (queue_.cancel(id)) {
      cancel_at_work_ = true;
      request = request_;
    }
  }
  if (request) request->cancel();
}

void EditStream::begin() {
  // Checked here and not on reading: requests that were sent ahead are not to be carried out
  // either.
  try {
    record_->check_still_admitted(*context_);
  } catch (const Error& why) {
    return close(to_status(why), why.info().reason);
  }
  begin_next();
}

void EditStream::begin_next() {
  Request request;
  {
    const std::scoped_lock lock(mutex_);
    if (!queue_.may_begin()) return;  // closed meanwhile
    cancel_at_work_ = false;
    request = queue_.begin();
    began_ = std::chrono::steady_clock::now();
  }
  answering(request.turn, [&] {
    catching([&] { hand_over(request); },
             [&](const Error& why) { fail(request.turn, request.id, why); });
  });
}

void EditStream::hand_over(Request& request) {
  if (request.cancelled) throw error::cancelled();
  if (request.refused) throw Error(*request.refused);
  CallGate::Pass pass = record_->enter();
  {
    const std::scoped_lock lock(mutex_);
    pass_ = std::move(pass);
  }
  const auto bytes = std::make_shared<std::string>(std::move(request.bytes));
  const auto mesh = std::make_shared<std::optional<v1::MeshSelection>>();
  const MakeRequestPtr started = session_.make(
      session_.admit(),
      [self = shared_from_this(), bytes, mesh] { return self->command(*bytes, *mesh); },
      listener(request.turn, request.id, mesh));
  bool cancel = false;
  {
    const std::scoped_lock lock(mutex_);
    if (!queue_.at_work(request.turn)) return;  // answered already
    request_ = started;
    cancel = cancel_at_work_ || closed_;
  }
  if (cancel) started->cancel();
}

Command EditStream::command(std::string& bytes, std::optional<v1::MeshSelection>& mesh) {
  v1::EditStreamRequest message;
  from_bytes(bytes, limits_.message_bytes, message);
  release(bytes);
  {
    const std::scoped_lock lock(mutex_);
    queue_.decoded();
  }
  if (message.has_mesh()) {
    check_selection(message.mesh());
    mesh = std::move(*message.mutable_mesh());
  }
  if (message.has_create()) return decode(message.create(), limits_.document);
  if (!message.has_edit()) throw error::side_invalid("request", "is empty");
  EditCommand edit = decode(message.edit(), limits_.document);
  const std::scoped_lock lock(mutex_);
  edit.last_design = next_base_;  // an id is the name of none
  if (edit.base.empty()) edit.base = edit.design.empty() ? next_base_ : edit.design;
  return edit;
}

Listener EditStream::listener(std::uint64_t turn, const std::string& id, SelectionPtr mesh) {
  const auto self = shared_from_this();
  return {.progress =
              [self, turn, id](const Progress& event) {
                self->safely([&] { self->progress(turn, id, event); });
              },
          .made =
              [self, turn, id, mesh](const Made& made) {
                self->answering(turn, [&] {
                  catching(
                      [&] {
                        v1::EditStreamResponse reply;
                        *reply.mutable_result() = encode(made, id);
                        count_made(self->record_->desk(), made);
                        {
                          const std::scoped_lock lock(self->mutex_);
                          const std::string& design = made.filed.place.design;
                          self->next_base_ = design.empty() ? made.filed.record.id : design;
                        }
                        self->answer(
                            turn, id, std::move(reply),
                            *mesh ? streamed_mesh(self->session_, made, id, **mesh) : nullptr);
                      },
                      [&](const Error& why) { self->fail(turn, id, why); });
                });
              },
          .failed =
              [self, turn, id](const Error& why) {
                self->answering(turn, [&] { self->fail(turn, id, why); });
              }};
}

void EditStream::fail(std::uint64_t turn, const std::string& id, const Error& why) {
  v1::EditStreamResponse reply;
  *reply.mutable_error() = to_message(why);
  answer(turn, id, std::move(reply));
}

void EditStream::answer(std::uint64_t turn, const std::string& id, v1::EditStreamResponse reply,
                        ReplySourcePtr rest) {
  reply.set_request_id(id);
  grpc::ByteBuffer bytes = to_bytes(reply);
  std::chrono::duration<double> spent{};
  {
    const std::scoped_lock lock(mutex_);
    if (!queue_.answer(turn, std::move(bytes), std::move(rest))) return;
    request_ = nullptr;
    pass_.reset();
    reply.has_error() ? ++failed_ : ++answered_;
    spent = std::chrono::steady_clock::now() - began_;
  }
  record_->count_request(static_cast<grpc::StatusCode>(reply.error().code()),
                         v1::Error::Reason_Name(reply.error().reason()), spent.count());
  advance();
}

void EditStream::progress(std::uint64_t turn, const std::string& id, const Progress& event) {
  v1::EditStreamResponse reply;
  reply.set_request_id(id);
  *reply.mutable_progress() = encode(event);
  grpc::ByteBuffer bytes = to_bytes(reply);
  {
    const std::scoped_lock lock(mutex_);
    queue_.progress(turn, std::move(bytes));
  }
  advance();
}

template <typename Action>
void EditStream::act(std::unique_lock<std::mutex>& lock, Action action) noexcept {
  ++acting_;
  lock.unlock();
  safely(std::move(action));
  lock.lock();
  --acting_;
}

void EditStream::advance() noexcept {
  std::unique_lock lock(mutex_);
  while (!finished_) {
    if (!closed_ && !writing_ && queue_.has_reply()) {
      writing_ = true;
      auto [bytes, source] = queue_.next_reply();
      outgoing_ = std::move(bytes);
      bool started = false;
      act(lock, [&] {
        if (source) outgoing_ = source->next();
        started = true;
        StartWrite(&outgoing_);
      });
      if (!started) writing_ = false;  // no OnWriteDone comes; `safely` has closed the stream
    } else if (!closed_ && !beginning_ && queue_.may_begin()) {
      // An answer within `begin` calls `advance` again: the next request is left to this loop.
      beginning_ = true;
      act(lock, [this] { begin(); });
      beginning_ = false;
    } else if (!closed_ && !reading_ && !reads_done_ && queue_.may_read()) {
      reading_ = true;
      act(lock, [this] { StartRead(&incoming_); });
    } else if ((closed_ || reads_done_) && acting_ == 0 && !writing_ && queue_.idle()) {
      finished_ = true;
      lock.unlock();
      return finish();
    } else {
      return;
    }
  }
}

void EditStream::OnWriteDone(bool ok) {
  const auto self = shared_from_this();
  {
    const std::scoped_lock lock(mutex_);
    writing_ = false;
    queue_.written();
    outgoing_.Clear();
  }
  if (!ok) close(grpc::Status::CANCELLED);
  advance();
}

void EditStream::OnCancel() {
  const auto self = shared_from_this();
  close(grpc::Status::CANCELLED);
  advance();
}

void EditStream::close(grpc::Status status, std::string reason) noexcept {
  MakeRequestPtr request;
  {
    const std::scoped_lock lock(mutex_);
    // `finish` reads these without the mutex.
    if (!finished_ && !std::exchange(closed_, true)) {
      end_status_ = std::move(status);
      end_reason_ = std::move(reason);
    }
    queue_.close();
    request = request_;
  }
  try {
    if (request) request->cancel();
  } catch (...) {  // without the memory to stop it, it goes on to its end
  }
}

void EditStream::finish() noexcept {
  try {
    record_->set_note("answered=" + std::to_string(answered_) +
                      " failed=" + std::to_string(failed_));
  } catch (...) {  // the log's line does without
  }
  record_->set_status(end_status_, end_reason_);
  Finish(end_status_);
}

void EditStream::OnDone() {
  record_->end();
  const auto self = std::move(self_);
}

}  // namespace remeshd
