#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/base/error.h"
#include "server/admission/memory_budget.h"
#include "server/limits.h"

namespace remeshd {

/// Replies that are made one by one as the client takes them: a mesh has many, and large ones.
class ReplySource {
 public:
  virtual ~ReplySource() = default;
  virtual grpc::ByteBuffer next() = 0;
  /// Whether `next` has given the last.
  [[nodiscard]] virtual bool ended() const = 0;
  /// Bytes that it takes in memory beside the revision.
  [[nodiscard]] virtual std::uint64_t own_bytes() const { return 0; }
};
using ReplySourcePtr = std::shared_ptr<ReplySource>;

/// What one EditStream holds for its client: requests sent ahead, the one at work, replies that the
/// client has not taken yet. All of it is bounded: at a bound nothing more is read or begun, until
/// replies have been taken. Requests wait as the bytes they came in, so that they cost what the
/// client spent on them. All that waits is taken from the memory budget.
///
/// Replies leave in the order of the requests. Not locked: the stream's mutex guards it.
class StreamQueue {
 public:
  struct Limits {
    std::size_t requests = limits::kStreamRequests;
    std::size_t request_bytes = limits::kStreamRequestBytes;
    std::size_t replies = limits::kStreamReplies;
    std::size_t reply_bytes = limits::kStreamReplyBytes;
    std::size_t sources = limits::kStreamMeshes;  ///< each keeps the mesh of a revision in memory
  };
  struct Request {
    std::string id;
    std::string bytes;             ///< the message
    std::optional<Error> refused;  ///< found unfit while it was read; `bytes` are empty then
    bool cancelled = false;
    std::uint64_t turn = 0;  ///< its number, once begun
  };

  /// `memory`: the stream's share of the budget, which grows and shrinks with what waits.
  explicit StreamQueue(MemoryBudget::Lease memory) : memory_(std::move(memory)) {}
  StreamQueue(MemoryBudget::Lease memory, const Limits& limits)
      : limits_(limits), memory_(std::move(memory)) {}

  /// Whether another message may be read. Its size is not known yet, so the bounds may be exceeded,
  /// but by one message at most.
  [[nodiscard]] bool may_read() const;
  /// Leases memory for a request of so many bytes, which is to be added next; false where the
  /// budget has no room.
  [[nodiscard]] bool make_room(std::size_t bytes);
  void add(Request request);

  /// Whether a request waits that may be begun: none is at work, and there is room for replies.
  [[nodiscard]] bool may_begin() const;
  /// Takes the first waiting request; it is at work until `answer`. Pre: `may_begin`.
  Request begin();
  /// The bytes of the request at work have been freed.
  void decoded();

  /// Marks all waiting requests of this id as cancelled. True if the request at work has the id.
  bool cancel(const std::string& id);
  /// Whether the request begun as number `turn` is still at work.
  [[nodiscard]] bool at_work(std::uint64_t turn) const { return at_work_ && turn_ == turn; }

  /// Adds a progress event of request `turn`. A client that reads slowly gets the latest event
  /// instead of all of them, and none of a request that has ended.
  void progress(std::uint64_t turn, grpc::ByteBuffer reply);
  /// Ends the request at work; false, and nothing done, if it is another one. `rest`: more replies
  /// to it; may be null.
  bool answer(std::uint64_t turn, grpc::ByteBuffer reply, ReplySourcePtr rest = nullptr);

  [[nodiscard]] bool has_reply() const { return !replies_.empty(); }
  /// A reply to be written, or where `source` is set, what makes it. Pre: `has_reply`, and the last
  /// one was `written`.
  struct Next {
    grpc::ByteBuffer bytes;
    ReplySourcePtr source;
  };
  Next next_reply();
  /// The reply that was taken last has been written.
  void written();

  /// Drops waiting requests and replies, and accepts none from now on. The request at work stays at
  /// work until `answer`.
  void close();
  /// Nothing waits, nothing is at work, every reply has been taken.
  [[nodiscard]] bool idle() const { return !at_work_ && waiting_.empty() && replies_.empty(); }

 private:
  struct Reply {
    grpc::ByteBuffer bytes;
    bool is_progress = false;
    ReplySourcePtr source{};
  };
  [[nodiscard]] bool room_for_replies() const;
  [[nodiscard]] std::uint64_t bytes() const;
  /// Adjusts the lease to `bytes`.
  void take_memory();
  void push(Reply reply);
  void drop_progress();

  Limits limits_;
  std::deque<Request> waiting_;
  std::size_t waiting_bytes_ = 0, work_bytes_ = 0;
  std::deque<Reply> replies_;
  std::size_t reply_bytes_ = 0;
  std::size_t sources_ = 0;  ///< among the replies
  std::uint64_t source_bytes_ = 0;
  bool at_work_ = false;
  std::uint64_t turn_ = 0;
  std::string at_work_id_;
  bool closed_ = false;
  MemoryBudget::Lease memory_;
};

}  // namespace remeshd
