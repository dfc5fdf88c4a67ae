#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

#include "server/admission/memory_budget.h"
#include "server/service/call.h"
#include "server/service/status.h"

namespace remeshd {

/// A call with one request and a stream of replies. Messages wait here until the client takes them;
/// whoever makes them stops at a bound (`wait_for_client`) and is told when to go on, so that a
/// client that does not read costs neither memory without end nor a thread.
///
/// Whoever works for it holds a shared_ptr; gRPC's own hold ends with OnDone. Writes and the end
/// are started under the mutex, one after the other, and nothing after `Finish`.
class MessageStream final : public grpc::ServerWriteReactor<grpc::ByteBuffer>,
                            public std::enable_shared_from_this<MessageStream> {
 public:
  static std::shared_ptr<MessageStream> start(grpc::CallbackServerContext* context,
                                              std::shared_ptr<CallRecord> record);
  /// Use `start`.
  MessageStream(grpc::CallbackServerContext* context, std::shared_ptr<CallRecord> record)
      : context_(context), record_(std::move(record)) {}

  /// Adds a message to what waits; nothing once the call has ended.
  /// Throws Error(Unauthenticated) where the client's token does not count any more.
  void send(grpc::ByteBuffer message);
  void send(const google::protobuf::Message& message) { send(to_bytes(message)); }
  /// Whether nothing waits for the client.
  [[nodiscard]] bool all_taken() const;
  /// True where no more is to be sent now: `limits::kUntakenBytes` wait for the client, or the call
  /// has ended. Then `go_on` is called once the client has taken enough, by a thread of gRPC that
  /// must not be kept; never where the call ends before.
  bool wait_for_client(std::function<void()> go_on);
  /// Keeps the lease of the messages' memory until the call has ended.
  void keep(MemoryBudget::Lease memory);

  /// Ends the call once everything is sent. Only the first end has an effect.
  void end() noexcept { end(grpc::Status::OK); }
  /// The same with an error; what the client has not been sent yet is dropped.
  void fail(const Error& why) noexcept;
  /// As `fail`, where there is no memory for an Error.
  void give_up() noexcept;

  /// Stops when the client cancels or its deadline passes.
  [[nodiscard]] std::stop_token stop_token() const { return stop_.get_token(); }
  /// Asks the work for this call to stop.
  void stop() { stop_.request_stop(); }
  CallRecord& record() { return *record_; }

  void OnWriteDone(bool ok) override;
  void OnCancel() override { stop_.request_stop(); }
  void OnDone() override;

 private:
  void end(const grpc::Status& status, const std::string& reason = {}) noexcept;
  void drop_waiting() noexcept;
  void finish_if_sent() noexcept;

  grpc::CallbackServerContext* const context_;
  const std::shared_ptr<CallRecord> record_;
  std::shared_ptr<MessageStream> self_;
  std::stop_source stop_;
  struct Waiting {
    grpc::ByteBuffer bytes;
    std::size_t size = 0;
  };
  mutable std::mutex mutex_;     ///< guards what follows
  std::deque<Waiting> waiting_;  ///< the first is being written
  std::size_t waiting_bytes_ = 0;
  std::function<void()> go_on_;  ///< empty: nobody waits for the client
  MemoryBudget::Lease memory_;
  bool ended_ = false, finished_ = false;
  grpc::Status status_;
};

}  // namespace remeshd
