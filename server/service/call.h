#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>
#include <spdlog/logger.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "server/service/front_desk.h"
#include "server/session/catching.h"

namespace remeshd {

/// Bytes of a message; equal messages give equal bytes, maps included.
grpc::ByteBuffer to_bytes(const google::protobuf::Message& message);

/// Reads a message of at most `limit` bytes.
/// Throws Error(InvalidArgument): `MESSAGE_TOO_LARGE`, `MESSAGE_UNREADABLE` (mostly values nested
/// too deep; gRPC itself would end such a call with UNIMPLEMENTED and an empty message).
void from_bytes(const grpc::ByteBuffer& bytes, std::size_t limit,
                google::protobuf::Message& message);
void from_bytes(std::string_view bytes, std::size_t limit, google::protobuf::Message& message);
/// The first check of `from_bytes`.
void check_size(std::size_t bytes, std::size_t limit);

/// A call at the front desk. When it ends it writes one line of the log: number, method, peer,
/// request id, duration, status, `traceparent` of the client. Without memory for it, the line is
/// left out.
class CallRecord {
 public:
  CallRecord(FrontDeskPtr desk, std::string method, const grpc::ServerContextBase& context);

  /// Lets the call in: finds its tenant and passes the gate; it counts as under way until `end`. To
  /// be called before anything is done for it.
  /// Throws what Doorman::tenant_of and CallGate::enter throw.
  void admit(const grpc::ServerContextBase& context);
  /// For a stream: finds its tenant only. Each of its requests passes the gate by itself (`enter`).
  void admit_stream(const grpc::ServerContextBase& context);
  /// For a stream that goes on: the file of tokens may have been read anew since it was let in.
  /// Throws what Doorman::check_again throws.
  void check_still_admitted(const grpc::ServerContextBase& context) const;
  [[nodiscard]] CallGate::Pass enter() const { return desk_->gate->enter(); }
  /// Whose call it is; set by `admit`. Empty where the daemon asks for no tokens.
  [[nodiscard]] const std::string& tenant() const { return tenant_; }
  [[nodiscard]] const FrontDesk& desk() const { return *desk_; }

  void set_request_id(std::string id);
  void set_status(const grpc::Status& status, const std::string& reason = {}) noexcept;
  /// Adds `note`, `name=value` words that say what the call did, to the log's line.
  void set_note(std::string note);
  /// Counts the call as an open stream until `end`.
  void count_as_stream();
  /// A request of a stream has ended.
  void count_request(grpc::StatusCode code, const std::string& reason,
                     double seconds) const noexcept;
  /// The call has ended: writes the line.
  void end() noexcept;

 private:
  const FrontDeskPtr desk_;
  std::uint64_t number_;
  const std::string method_;
  const std::string peer_;
  std::string trace_parent_;  ///< empty where the client sent none
  std::string tenant_;
  CallGate::Pass pass_;
  bool streams_ = false;  ///< counts as an open stream
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  mutable std::mutex mutex_;
  const char* status_ = "CANCELLED";
  std::string request_id_, reason_, note_;
};

/// Ends a unary call for which nothing was begun, at a fraction of the cost of a UnaryCall: there
/// may be very many.
grpc::ServerUnaryReactor* refuse(grpc::CallbackServerContext& context, CallRecord& record,
                                 const Error& why) noexcept;

/// Does `work` for a call; an exception of any kind becomes the end of the call. For gRPC's
/// callbacks and for work on other threads, which no exception may leave.
template <typename Call, typename Work>
void answering(Call& call, Work&& work) noexcept {
  try {
    catching(std::forward<Work>(work), [&](const Error& why) { call.fail(why); });
  } catch (...) {
    call.give_up();
  }
}

/// A call with one request and one reply, from raw bytes to raw bytes. Whoever works for it holds a
/// shared_ptr; gRPC's own hold ends with OnDone. Its only operation is `Finish`, which is done
/// once.
class UnaryCall final : public grpc::ServerUnaryReactor,
                        public std::enable_shared_from_this<UnaryCall> {
 public:
  static std::shared_ptr<UnaryCall> start(grpc::CallbackServerContext* context,
                                          grpc::ByteBuffer* reply,
                                          std::shared_ptr<CallRecord> record);
  /// Use `start`.
  UnaryCall(grpc::CallbackServerContext* context, grpc::ByteBuffer* reply,
            std::shared_ptr<CallRecord> record)
      : context_(context), reply_(reply), record_(std::move(record)) {}

  /// Ends the call. Of `reply`, `fail` and `give_up` only the first has an effect.
  void reply(const google::protobuf::Message& message);
  void fail(const Error& error) noexcept;
  /// As `fail`, where there is no memory for an Error.
  void give_up() noexcept;

  /// Adds an action for when the client cancels or its deadline passes; called at once where that
  /// has happened already, never once the call is done.
  void on_cancel(std::function<void()> action);
  /// Stops when the client cancels or its deadline passes.
  [[nodiscard]] std::stop_token stop_token() const { return stop_.get_token(); }
  /// Asks the work for this call to stop.
  void stop() { stop_.request_stop(); }
  CallRecord& record() { return *record_; }

  void OnCancel() override;
  void OnDone() override;

 private:
  /// Pre: `ended_` was set by the caller.
  void finish(const grpc::Status& status, const std::string& reason = {}) noexcept;

  grpc::CallbackServerContext* context_;
  grpc::ByteBuffer* reply_;
  std::shared_ptr<CallRecord> record_;
  std::stop_source stop_;
  std::atomic<bool> ended_ = false;
  std::mutex mutex_;
  bool cancelled_ = false, done_ = false;
  std::vector<std::function<void()>> on_cancel_;
  std::shared_ptr<UnaryCall> self_;
};

}  // namespace remeshd
