#include "server/service/mesh_call.h"

#include "server/service/mesh_bytes.h"
#include "server/service/mesh_messages.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

/// Sends messages until enough of them wait for the client, and goes on once it has taken them.
void write(const std::shared_ptr<MessageStream>& stream,
           const std::shared_ptr<MeshMessages>& messages) {
  const auto go_on = [stream, messages] { write(stream, messages); };
  PartData data;
  for (v1::GetMeshResponse response; messages->next(*response.mutable_mesh(), data);) {
    stream->send(mesh_bytes(response, data));
    if (stream->wait_for_client(go_on)) return;
  }
  stream->end();
}

void begin(const std::shared_ptr<MessageStream>& stream, Session& session,
           const v1::GetMeshRequest& request, const HeldRevisionPtr& revision) {
  stream->record().set_note("revision=" + revision->record.id.substr(0, 12));
  const Run run{.stop = stream->stop_token(), .on_progress = {}, .dumps = {}};
  const HeldRevisionPtr parent =
      request.selection().delta() ? session.parent_of(*revision, run) : nullptr;
  const auto messages = std::make_shared<MeshMessages>(revision, parent, request.selection());
  // Leased after the reads above have returned their memory, which may be the whole budget.
  stream->keep(session.take_reply_memory(messages->own_bytes(), run.stop));
  if (request.has_resume_from()) messages->resume_from(request.resume_from());
  write(stream, messages);
}

}  // namespace

void send_mesh(const std::shared_ptr<MessageStream>& stream, Session& session,
               const v1::GetMeshRequest& request) {
  check_selection(request.selection());
  session.fetch(session.resolve(request.revision()).id, stream->stop_token(),
                {.got =
                     [stream, &session, request](const HeldRevisionPtr& revision) {
                       answering(*stream, [&] { begin(stream, session, request, revision); });
                     },
                 .failed = [stream](const Error& why) { stream->fail(why); }});
}

}  // namespace remeshd
