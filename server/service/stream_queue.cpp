#include "server/service/stream_queue.h"

#include <utility>

namespace remeshd {
namespace {

/// What a stream in which so many bytes wait takes from the budget.
std::uint64_t share_of(std::uint64_t bytes) {
  if (bytes <= limits::kStreamSpare) return limits::kStreamMemory;
  const std::uint64_t parts = (bytes + limits::kStreamMemory - 1) / limits::kStreamMemory;
  return (1 + parts) * limits::kStreamMemory;
}

}  // namespace

std::uint64_t StreamQueue::bytes() const {
  return waiting_bytes_ + work_bytes_ + reply_bytes_ + source_bytes_;
}

void StreamQueue::take_memory() { memory_.resize(share_of(bytes())); }

bool StreamQueue::make_room(std::size_t more) {
  return closed_ || memory_.try_resize(share_of(bytes() + more));
}

bool StreamQueue::room_for_replies() const {
  return replies_.size() < limits_.replies && reply_bytes_ < limits_.reply_bytes;
}

bool StreamQueue::may_read() const {
  return waiting_.size() < limits_.requests && waiting_bytes_ < limits_.request_bytes &&
         room_for_replies();
}

void StreamQueue::add(Request request) {
  if (closed_) return;
  const std::size_t bytes = request.bytes.size();
  waiting_.push_back(std::move(request));
  waiting_bytes_ += bytes;
  take_memory();
}

bool StreamQueue::may_begin() const {
  return !at_work_ && !waiting_.empty() && room_for_replies() && sources_ < limits_.sources;
}

StreamQueue::Request StreamQueue::begin() {
  at_work_id_ = waiting_.front().id;
  Request request = std::move(waiting_.front());
  waiting_.pop_front();
  waiting_bytes_ -= request.bytes.size();
  work_bytes_ = request.bytes.size();
  request.turn = ++turn_;
  at_work_ = true;
  return request;
}

void StreamQueue::decoded() {
  work_bytes_ = 0;
  take_memory();
}

bool StreamQueue::cancel(const std::string& id) {
  for (Request& request : waiting_)
    if (request.id == id) request.cancelled = true;
  return at_work_ && at_work_id_ == id;
}

void StreamQueue::push(Reply reply) {
  const std::size_t bytes = reply.bytes.Length();
  replies_.push_back(std::move(reply));
  reply_bytes_ += bytes;
}

void StreamQueue::drop_progress() {
  if (replies_.empty() || !replies_.back().is_progress) return;
  reply_bytes_ -= replies_.back().bytes.Length();
  replies_.pop_back();
}

void StreamQueue::progress(std::uint64_t turn, grpc::ByteBuffer reply) {
  if (closed_ || !at_work(turn)) return;
  drop_progress();
  push({.bytes = std::move(reply), .is_progress = true});
  take_memory();
}

bool StreamQueue::answer(std::uint64_t turn, grpc::ByteBuffer reply, ReplySourcePtr rest) {
  if (!at_work(turn)) return false;
  if (!closed_) {
    drop_progress();
    push({.bytes = std::move(reply)});
    if (rest) {
      source_bytes_ += rest->own_bytes();
      push({.source = std::move(rest)});
      ++sources_;
    }
  }
  at_work_ = false;
  work_bytes_ = 0;
  take_memory();
  return true;
}

StreamQueue::Next StreamQueue::next_reply() {
  Reply& first = replies_.front();
  if (first.source) return {.source = first.source};
  Next next{.bytes = std::move(first.bytes)};
  replies_.pop_front();
  reply_bytes_ -= next.bytes.Length();
  return next;
}

void StreamQueue::written() {
  if (!replies_.empty() && replies_.front().source && replies_.front().source->ended()) {
    source_bytes_ -= replies_.front().source->own_bytes();
    replies_.pop_front();
    --sources_;
  }
  take_memory();
}

void StreamQueue::close() {
  closed_ = true;
  waiting_.clear();
  waiting_bytes_ = 0;
  replies_.clear();
  reply_bytes_ = 0;
  sources_ = 0;
  source_bytes_ = 0;
  take_memory();
}

}  // namespace remeshd
