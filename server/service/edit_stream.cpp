#include "server/service/edit_stream.h"

#include <utility>

#include "server/service/decode.h"
#include "server/service/encode.h"
#include "server/service/status.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

// What a client may send ahead before the stream stops reading. Cancellations pass as long as it
// reads.
constexpr std::size_t kMostWaiting = 4096;
constexpr std::size_t kMostWaitingBytes = std::size_t{32} << 20;

}  // namespace

EditStream::EditStream(Session& session, std::size_t message_limit,
                       std::shared_ptr<CallRecord> record)
    : session_(session), message_limit_(message_limit), record_(std::move(record)) {}

EditStream* EditStream::start(Session& session, std::size_t message_limit,
                              std::shared_ptr<CallRecord> record) {
  auto stream = std::make_shared<EditStream>(session, message_limit, std::move(record));
  stream->self_ = stream;
  stream->reading_ = true;
  stream->StartRead(&stream->incoming_);
  return stream.get();
}

bool EditStream::full() const {
  return waiting_.size() >= kMostWaiting || waiting_bytes_ >= kMostWaitingBytes;
}

void EditStream::OnReadDone(bool ok) {
  const auto self = shared_from_this();
  if (ok) take(incoming_);
  {
    const std::scoped_lock lock(mutex_);
    reading_ = false;
    if (!ok) reads_done_ = true;
  }
  read_more();
  pump();
  finish_if_done();
}

void EditStream::read_more() {
  {
    const std::scoped_lock lock(mutex_);
    if (reading_ || reads_done_ || cancelled_ || finished_ || full()) return;
    reading_ = true;
  }
  StartRead(&incoming_);
}

void EditStream::take(const grpc::ByteBuffer& bytes) {
  Waiting waiting{.id = "", .command = CreateCommand{}, .bytes = bytes.Length()};
  try {
    v1::EditStreamRequest message;
    from_bytes(bytes, message_limit_, message);
    switch (message.request_case()) {
      case v1::EditStreamRequest::kCancel:
        cancel_by_id(message.cancel().request_id());
        return;
      case v1::EditStreamRequest::kCreate:
        waiting.id = message.create().request_id();
        waiting.command = decode(message.create());
        break;
      case v1::EditStreamRequest::kEdit:
        waiting.id = message.edit().request_id();
        waiting.command = decode(message.edit());
        break;
      default:
        throw error::side_invalid("request", "is empty");
    }
  } catch (const Error& failure) {
    waiting.command = failure;
  }
  const std::scoped_lock lock(mutex_);
  if (cancelled_) return;
  waiting_bytes_ += waiting.bytes;
  waiting_.push_back(std::move(waiting));
}

void EditStream::cancel_by_id(const std::string& id) {
  MakeRequestPtr request;
  {
    const std::scoped_lock lock(mutex_);
    for (Waiting& waiting : waiting_)
      if (waiting.id == id) waiting.cancelled = true;
    if (busy_ && at_work_ == id) {
      cancel_at_work_ = true;
      request = request_;
    }
  }
  if (request) request->cancel();
}

void EditStream::pump() {
  std::unique_lock lock(mutex_);
  // Whoever is in the loop below looks again once it has the lock back.
  if (pumping_) return;
  pumping_ = true;
  while (!busy_ && !waiting_.empty()) {
    Waiting request = std::move(waiting_.front());
    waiting_.pop_front();
    waiting_bytes_ -= request.bytes;
    busy_ = true;
    ++turn_;
    at_work_ = request.id;
    cancel_at_work_ = false;
    request_ = nullptr;
    lock.unlock();
    launch(std::move(request));
    read_more();
    lock.lock();
  }
  pumping_ = false;
}

void EditStream::launch(Waiting request) {
  const auto self = shared_from_this();
  const std::string id = request.id;
  std::uint64_t turn = 0;
  {
    const std::scoped_lock lock(mutex_);
    turn = turn_;
  }
  const Listener listener{
      .progress = [self, turn, id](const Progress& event) { self->progress(turn, id, event); },
      .made =
          [self, id](const Made& made) {
            {
              const std::scoped_lock lock(self->mutex_);
              self->design_ = made.filed.place.design;
            }
            v1::EditStreamReply reply;
            *reply.mutable_revision() = encode(made, id);
            self->answer(id, std::move(reply));
          },
      .failed =
          [self, id](const Error& failure) {
            v1::EditStreamReply reply;
            *reply.mutable_error() = to_message(failure);
            self->answer(id, std::move(reply));
          }};

  if (request.cancelled) return listener.failed(error::cancelled());
  if (const auto* failure = std::get_if<Error>(&request.command)) return listener.failed(*failure);

  MakeRequestPtr started;
  if (auto* create = std::get_if<CreateCommand>(&request.command)) {
    started = session_.create(std::move(*create), listener);
  } else {
    auto& edit = std::get<EditCommand>(request.command);
    if (edit.base.empty()) {
      const std::scoped_lock lock(mutex_);
      edit.base = edit.design.empty() ? design_ : edit.design;
    }
    started = session_.edit(std::move(edit), listener);
  }
  bool cancel = false;
  {
    const std::scoped_lock lock(mutex_);
    if (!busy_ || turn_ != turn) return;  // answered already
    request_ = started;
    cancel = cancel_at_work_ || cancelled_;
  }
  if (cancel) started->cancel();
}

void EditStream::answer(const std::string& id, v1::EditStreamReply reply) {
  reply.set_request_id(id);
  {
    const std::scoped_lock lock(mutex_);
    busy_ = false;
    request_ = nullptr;
    reply.has_error() ? ++failed_ : ++answered_;
    if (!cancelled_ && !finished_) replies_.push_back(std::move(reply));
  }
  write_next();
  pump();
  finish_if_done();
}

void EditStream::progress(std::uint64_t turn, const std::string& id, const Progress& event) {
  {
    const std::scoped_lock lock(mutex_);
    if (!busy_ || turn_ != turn || cancelled_ || finished_) return;
    v1::EditStreamReply reply;
    reply.set_request_id(id);
    *reply.mutable_progress() = encode(event);
    // A client that reads slowly gets the latest event instead of all of them.
    if (!replies_.empty() && replies_.back().has_progress()) {
      replies_.back() = std::move(reply);
    } else {
      replies_.push_back(std::move(reply));
    }
  }
  write_next();
}

void EditStream::write_next() {
  {
    const std::scoped_lock lock(mutex_);
    if (writing_ || finished_ || cancelled_ || replies_.empty()) return;
    writing_ = true;
    outgoing_ = to_bytes(replies_.front());
    replies_.pop_front();
  }
  StartWrite(&outgoing_);
}

void EditStream::OnWriteDone(bool ok) {
  const auto self = shared_from_this();
  {
    const std::scoped_lock lock(mutex_);
    writing_ = false;
    if (!ok) cancelled_ = true;
    if (cancelled_) replies_.clear();
  }
  write_next();
  finish_if_done();
}

void EditStream::OnCancel() {
  const auto self = shared_from_this();
  MakeRequestPtr request;
  {
    const std::scoped_lock lock(mutex_);
    cancelled_ = true;
    waiting_.clear();
    waiting_bytes_ = 0;
    replies_.clear();
    request = request_;
  }
  if (request) request->cancel();
  finish_if_done();
}

void EditStream::finish_if_done() {
  bool cancelled = false;
  {
    const std::scoped_lock lock(mutex_);
    const bool quiet = !busy_ && !writing_ && waiting_.empty() && replies_.empty();
    if (finished_ || !quiet || !(reads_done_ || cancelled_)) return;
    finished_ = true;
    cancelled = cancelled_;
    record_->set_note("answered=" + std::to_string(answered_) +
                      " failed=" + std::to_string(failed_));
  }
  const grpc::Status status = cancelled ? grpc::Status::CANCELLED : grpc::Status::OK;
  record_->set_status(status);
  Finish(status);
}

void EditStream::OnDone() {
  record_->end();
  const auto self = std::move(self_);
}

}  // namespace remeshd
