#include "server/service/mesh_call.h"

#include <utility>

namespace remeshd {

namespace v1 = remesh::v1;

MeshCall* MeshCall::start(Tenants& tenants, grpc::CallbackServerContext* context,
                          const grpc::ByteBuffer& request, std::size_t message_limit,
                          std::shared_ptr<CallRecord> record) {
  auto call = std::make_shared<MeshCall>(context, std::move(record));
  call->self_ = call;
  answering(*call, [&] {
    call->record_->admit(*context);
    call->record_->count_as_stream();
    Session& session = tenants.of(call->record_->tenant());
    session.later(Lane::Preparation,
                  {.run =
                       [call, &session, bytes = grpc::ByteBuffer(request), message_limit] {
                         answering(*call, [&] { call->fetch(session, bytes, message_limit); });
                       },
                   .refused = [call](const Error& why) { call->fail(why); }});
  });
  return call.get();
}

void MeshCall::fetch(Session& session, const grpc::ByteBuffer& request, std::size_t message_limit) {
  const auto message = std::make_shared<v1::GetMeshRequest>();
  from_bytes(request, message_limit, *message);
  check_selection(message->selection());
  const auto call = shared_from_this();
  session.fetch(session.resolve(message->revision()).id, stop_.get_token(),
                {.got =
                     [call, &session, message](const HeldRevisionPtr& revision) {
                       answering(*call, [&] { call->begin(session, *message, revision); });
                     },
                 .failed = [call](const Error& why) { call->fail(why); }});
}

void MeshCall::begin(Session& session, const v1::GetMeshRequest& request,
                     const HeldRevisionPtr& revision) {
  record_->set_note("revision=" + revision->record.id.substr(0, 12));
  const Run run{.stop = stop_.get_token(), .on_progress = {}, .dumps = {}};
  run.poll();  // the mesh may have been made for others too
  const HeldRevisionPtr parent =
      request.selection().delta() ? session.parent_of(*revision, run) : nullptr;
  messages_.emplace(revision, parent, request.selection());
  if (request.has_resume_from()) messages_->resume_from(request.resume_from());
  write_next();
}

void MeshCall::write_next() {
  v1::GetMeshResponse response;
  if (!messages_->next(*response.mutable_mesh())) return end(grpc::Status::OK);
  outgoing_ = to_bytes(response);
  StartWrite(&outgoing_);
}

void MeshCall::OnWriteDone(bool ok) {
  if (!ok || stop_.stop_requested()) return end(grpc::Status::CANCELLED);
  answering(*this, [&] { write_next(); });
}

void MeshCall::fail(const Error& why) noexcept {
  if (ended_) return;
  add_pushback(why, *context_);
  end(to_status(why), why.info().reason);
}

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
