#include "server/service/message_stream.h"

#include <utility>

#include "server/limits.h"

namespace remeshd {

std::shared_ptr<MessageStream> MessageStream::start(grpc::CallbackServerContext* context,
                                                    std::shared_ptr<CallRecord> record) {
  auto stream = std::make_shared<MessageStream>(context, std::move(record));
  stream->self_ = stream;
  return stream;
}

void MessageStream::send(grpc::ByteBuffer message) {
  const std::scoped_lock lock(mutex_);
  if (ended_) return;
  record_->check_still_admitted(*context_);  // gRPC keeps the context until the end
  const std::size_t size = message.Length();
  waiting_.push_back({std::move(message), size});
  waiting_bytes_ += size;
  if (waiting_.size() == 1) StartWrite(&waiting_.front().bytes);
}

bool MessageStream::all_taken() const {
  const std::scoped_lock lock(mutex_);
  return waiting_.empty();
}

bool MessageStream::wait_for_client(std::function<void()> go_on) {
  const std::scoped_lock lock(mutex_);
  if (ended_) return true;
  if (waiting_bytes_ < limits::kUntakenBytes) return false;
  go_on_ = std::move(go_on);
  return true;
}

void MessageStream::keep(MemoryBudget::Lease memory) {
  const std::scoped_lock lock(mutex_);
  if (!ended_) memory_ = std::move(memory);
}

void MessageStream::OnWriteDone(bool ok) {
  const auto self = shared_from_this();  // `Finish` may lead to OnDone while the lock is held
  std::function<void()> go_on;
  {
    const std::scoped_lock lock(mutex_);
    waiting_bytes_ -= waiting_.front().size;
    waiting_.pop_front();
    if (!ok) waiting_.clear();
    if (!waiting_.empty()) StartWrite(&waiting_.front().bytes);
    if (ended_) {
      finish_if_sent();
    } else if (waiting_bytes_ < limits::kUntakenBytes) {
      go_on.swap(go_on_);
    }
  }
  if (!ok) return end(grpc::Status::CANCELLED);
  if (go_on) answering(*this, go_on);
}

void MessageStream::fail(const Error& why) noexcept {
  const auto self = weak_from_this().lock();
  {
    const std::scoped_lock lock(mutex_);
    if (ended_) return;
    drop_waiting();
    add_pushback(why, *context_);
  }
  end(to_status(why), why.info().reason);
}

void MessageStream::give_up() noexcept { end(out_of_memory_status()); }

/// Pre: under the mutex. What is being written stays.
void MessageStream::drop_waiting() noexcept {
  while (waiting_.size() > 1) {
    waiting_bytes_ -= waiting_.back().size;
    waiting_.pop_back();
  }
}

void MessageStream::end(const grpc::Status& status, const std::string& reason) noexcept {
  const auto self = weak_from_this().lock();  // as in OnWriteDone
  std::function<void()> dropped;              // released after the lock: it may hold this
  const std::scoped_lock lock(mutex_);
  if (std::exchange(ended_, true)) return;
  dropped.swap(go_on_);
  record_->set_status(status, reason);
  status_ = status;
  finish_if_sent();
}

/// Pre: under the mutex, and the call has ended.
void MessageStream::finish_if_sent() noexcept {
  if (waiting_.empty() && !std::exchange(finished_, true)) Finish(status_);
}

void MessageStream::OnDone() {
  record_->end();
  MemoryBudget::Lease memory;
  {
    const std::scoped_lock lock(mutex_);
    memory = std::move(memory_);
  }
  const auto self = std::move(self_);
}

}  // namespace remeshd
