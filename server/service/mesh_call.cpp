#include "server/service/mesh_call.h"

#include <utility>

namespace remeshd {

namespace v1 = remesh::v1;

MeshCall* MeshCall::start(Session& session, const grpc::ByteBuffer& request,
                          std::size_t message_limit, std::shared_ptr<CallRecord> record) {
  auto call = std::make_shared<MeshCall>(std::move(record));
  call->self_ = call;
  answering(*call, [&] {
    session.later(
        [call, &session, request, message_limit] {
          answering(*call, [&] {
            call->prepare(session, request, message_limit);
            call->write_next();
          });
        },
        [call](const Error& why) { call->fail(why); });
  });
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
  answering(*this, [&] { write_next(); });
}

void MeshCall::fail(const Error& why) noexcept { end(to_status(why), why.info().reason); }

void MeshCall::end(const grpc::Status& status, const std::string& reason) noexcept {
  if (ended_.exchange(true)) return;
  record_->set_status(status, reason);
  Finish(status);
}

void MeshCall::OnDone() {
  record_->end();
  const auto self = std::move(self_);
}

}  // namespace remeshd
