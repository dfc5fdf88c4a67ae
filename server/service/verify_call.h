#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <chrono>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

#include "remesh/v1/cache.pb.h"
#include "server/service/call.h"
#include "server/service/status.h"
#include "server/session/tenants.h"
#include "server/session/verification.h"

namespace remeshd {

/// One VerifyCache: the store is read in the lane of preparations, and what is found is sent as it
/// comes. While a mesh is made again, no thread waits for it. Nothing starts after `Finish`, and
/// the call lives until then.
class VerifyCall final : public grpc::ServerWriteReactor<grpc::ByteBuffer>,
                         public std::enable_shared_from_this<VerifyCall> {
 public:
  static VerifyCall* start(Tenants& tenants, grpc::CallbackServerContext* context,
                           const grpc::ByteBuffer& request, std::size_t message_limit,
                           std::shared_ptr<CallRecord> record);
  /// Use `start`.
  VerifyCall(grpc::CallbackServerContext* context, std::shared_ptr<CallRecord> record)
      : context_(context), record_(std::move(record)) {}

  void fail(const Error& why) noexcept;
  /// Without the memory for an Error.
  void give_up() noexcept { end(out_of_memory_status()); }

  void OnWriteDone(bool ok) override;
  void OnCancel() override { stop_.request_stop(); }
  void OnDone() override;

 private:
  void begin(Session& session, const remesh::v1::VerifyCacheRequest& request);
  void go_on();
  void go_on_later();
  void tell(const CacheFault& fault);
  void tell_progress();
  void send(const remesh::v1::VerifyCacheResponse& message);
  /// Ends the call once everything is sent; only the first end has an effect.
  void end(const grpc::Status& status, const std::string& reason = {}) noexcept;

  grpc::CallbackServerContext* const context_;
  const std::shared_ptr<CallRecord> record_;
  std::shared_ptr<VerifyCall> self_;
  std::stop_source stop_;

  // Of the one piece of work under way.
  Session* session_ = nullptr;
  bool repair_ = false;
  std::optional<Verification> verification_;
  remesh::v1::VerifyCacheResponse so_far_;
  std::chrono::steady_clock::time_point told_ = std::chrono::steady_clock::now();

  std::mutex mutex_;                      ///< guards what follows
  std::deque<grpc::ByteBuffer> waiting_;  ///< the first is being written
  bool ended_ = false, finished_ = false;
  grpc::Status status_;
};

}  // namespace remeshd
