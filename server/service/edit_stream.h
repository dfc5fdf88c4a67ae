#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <string>

#include "remesh/v1/remesh.pb.h"
#include "server/service/call.h"
#include "server/service/request_limits.h"
#include "server/service/stream_queue.h"
#include "server/session/tenants.h"

namespace remeshd {

/// One EditStream. Requests queue up and are handed to the session one at a time, so that an edit
/// sees the head that the one before it left, and answers keep their order.
///
/// `advance` alone starts operations of gRPC. An operation is decided on under the mutex, where
/// `acting_` counts it until the call that starts it has returned. `Finish` is decided on under the
/// same mutex, only while `acting_` is 0, and nothing is decided on after it. So no operation
/// starts after `Finish`; and as gRPC calls OnDone after `Finish` only, none starts on a stream
/// that is gone. Whoever calls `advance` holds a shared_ptr to the stream.
class EditStream final : public grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>,
                         public std::enable_shared_from_this<EditStream> {
 public:
  /// A stream that is not let in ends at once. Its tenant is the same for all its requests: where
  /// its token is not valid for that tenant any more, the stream ends instead of carrying out its
  /// next request.
  static grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>* start(
      Tenants& tenants, const RequestLimits& limits, grpc::CallbackServerContext* context,
      std::shared_ptr<CallRecord> record);
  /// Use `start`.
  EditStream(Session& session, const RequestLimits& limits, grpc::CallbackServerContext* context,
             std::shared_ptr<CallRecord> record, MemoryBudget::Lease memory);

  void OnReadDone(bool ok) override;
  void OnWriteDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

 private:
  using Request = StreamQueue::Request;
  using SelectionPtr = std::shared_ptr<std::optional<remesh::v1::MeshSelection>>;

  // What is read.
  void take();
  /// Fills in `request` from `incoming_`; false for a cancellation, which is carried out at once.
  bool read(Request& request);
  void cancel_by_id(const std::string& id);

  // What is handed to the session, and its answers.
  void begin();
  void begin_next();
  void hand_over(Request& request);
  /// The command in the bytes of a request, which are freed. `mesh` gets the request's selection of
  /// the mesh to send, if it has one. Throws Error: what is wrong with the request.
  Command command(std::string& bytes, std::optional<remesh::v1::MeshSelection>& mesh);
  Listener listener(std::uint64_t turn, const std::string& id, SelectionPtr mesh);
  void answer(std::uint64_t turn, const std::string& id, remesh::v1::EditStreamResponse reply,
              ReplySourcePtr rest = nullptr);
  void fail(std::uint64_t turn, const std::string& id, const Error& why);
  void progress(std::uint64_t turn, const std::string& id, const Progress& event);

  /// Does all that may be done now: write, begin a request, read, finish.
  void advance() noexcept;
  template <typename Action>
  void act(std::unique_lock<std::mutex>& lock, Action action) noexcept;
  void finish() noexcept;
  /// Drops what waits and stops what is at work; once that has answered, the stream ends with this
  /// status, for this reason in the log.
  void close(grpc::Status status, std::string reason = {}) noexcept;
  /// An exception that no request can be told of closes the stream.
  template <typename Work>
  void safely(Work&& work) noexcept;
  /// The same for the work that answers request `turn`; after an exception that gets no answer.
  template <typename Work>
  void answering(std::uint64_t turn, Work&& work) noexcept;

  Session& session_;
  const RequestLimits limits_;
  grpc::CallbackServerContext* const context_;
  const std::shared_ptr<CallRecord> record_;
  std::shared_ptr<EditStream> self_;

  // Used by the one read, and the one write, under way only.
  grpc::ByteBuffer incoming_, outgoing_;

  std::mutex mutex_;
  StreamQueue queue_;
  MakeRequestPtr request_;  ///< at work; null until the session has returned it
  CallGate::Pass pass_;     ///< of the request at work: an idle stream does not delay shutdown
  std::chrono::steady_clock::time_point began_;  ///< when the request at work was begun
  bool cancel_at_work_ = false;
  /// The base of an edit that names neither base nor design: the design of the last result, or the
  /// id of that result where it is in no design.
  std::string next_base_;
  int acting_ = 0;  ///< actions under way that `advance` decided on
  bool beginning_ = false;
  bool writing_ = false;
  bool reading_ = false;
  bool reads_done_ = false;
  bool closed_ = false;
  bool finished_ = false;
  grpc::Status end_status_;
  std::string end_reason_;
  std::uint64_t answered_ = 0, failed_ = 0;
};

}  // namespace remeshd
