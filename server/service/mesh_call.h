#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>

#include "server/service/call.h"
#include "server/service/mesh_messages.h"
#include "server/service/status.h"
#include "server/session/tenants.h"

namespace remeshd {

/// One GetMesh: the revision is fetched from the lane of preparations, then message follows message
/// as the client takes them. One thing happens after the other: preparation, a write, the next
/// write, the end. So no operation starts after `Finish`, and the call lives until then.
class MeshCall final : public grpc::ServerWriteReactor<grpc::ByteBuffer>,
                       public std::enable_shared_from_this<MeshCall> {
 public:
  static MeshCall* start(Tenants& tenants, grpc::CallbackServerContext* context,
                         const grpc::ByteBuffer& request, std::size_t message_limit,
                         std::shared_ptr<CallRecord> record);
  /// Use `start`.
  MeshCall(grpc::CallbackServerContext* context, std::shared_ptr<CallRecord> record)
      : context_(context), record_(std::move(record)) {}

  void fail(const Error& why) noexcept;
  /// Without the memory for an Error.
  void give_up() noexcept { end(out_of_memory_status()); }

  void OnWriteDone(bool ok) override;
  void OnCancel() override { stop_.request_stop(); }
  void OnDone() override;

 private:
  void fetch(Session& session, const grpc::ByteBuffer& request, std::size_t message_limit);
  void begin(Session& session, const remesh::v1::GetMeshRequest& request,
             const HeldRevisionPtr& revision);
  void write_next();
  /// Ends the call; only the first end has an effect.
  void end(const grpc::Status& status, const std::string& reason = {}) noexcept;

  grpc::CallbackServerContext* const context_;
  const std::shared_ptr<CallRecord> record_;
  std::shared_ptr<MeshCall> self_;
  std::stop_source stop_;
  std::optional<MeshMessages> messages_;
  grpc::ByteBuffer outgoing_;
  std::atomic<bool> ended_ = false;
};

}  // namespace remeshd
