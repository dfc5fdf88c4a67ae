#include "server/service/mesh_call.h"

#include <utility>

#include "server/service/status.h"
#include "server/session/session_error.h"

namespace remeshd {

namespace v1 = remesh::v1;

MeshCall* MeshCall::start(Session& session, const grpc::ByteBuffer& request,
                          std::size_t message_limit, std::shared_ptr<CallRecord> record) {
  auto call = std::make_shared<MeshCall>(std::move(record));
  call->self_ = call;
  const auto failed = [call](const Error& why) { call->end(to_status(why), why.info().reason); };
  try {
    session.later(
        [call, &session, request, message_limit, failed] {
          try {
            call->prepare(session, request, message_limit);
          } catch (const Error& failure) {
            return failed(failure);
          } catch (const std::exception& failure) {
            return failed(error::internal("request", failure.what()));
          }
          call->write_next();
        },
        failed);
  } catch (const Error& failure) {
    failed(failure);
  }
  return call.get();
}

void MeshCall::prepare(Session& session, const grpc::ByteBuffer& request,
                       std::size_t message_limit) {
  v1::GetMeshRequest message;
  from_bytes(request, message_limit, message);
  std::vector<v1::MeshArray> arrays;
  for (const int array : message.arrays()) arrays.push_back(static_cast<v1::MeshArray>(array));
  const HeldRevisionPtr revision = session.get(
      message.revision(), Run{.stop = stop_.get_token(), .on_progress = {}, .dumps = {}});
  record_->set_note("revision=" + revision->record.id.substr(0, 12));
  messages_.emplace(revision, arrays);
}

void MeshCall::write_next() {
  v1::MeshMessage message;
  if (!messages_->next(message)) return end(grpc::Status::OK);
  outgoing_ = to_bytes(message);
  StartWrite(&outgoing_);
}

void MeshCall::OnWriteDone(bool ok) {
  if (!ok || stop_.stop_requested()) return end(grpc::Status::CANCELLED);
  write_next();
}

void MeshCall::end(const grpc::Status& status, const std::string& reason) {
  record_->set_status(status, reason);
  Finish(status);
}

void MeshCall::OnDone() {
  record_->end();
  const auto self = std::move(self_);
}

}  // namespace remeshd
