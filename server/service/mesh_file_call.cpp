#include "server/service/mesh_file_call.h"

#include <algorithm>
#include <string>
#include <utility>

#include "proto/checksum.h"
#include "server/limits.h"
#include "server/service/mesh_file.h"
#include "server/service/revision_work.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

/// A file on its way to the client.
struct Sending {
  std::string file;
  std::size_t sent = 0;
};

/// Sends parts until enough of them wait for the client, and goes on once it has taken them.
void write(const std::shared_ptr<MessageStream>& stream, const std::shared_ptr<Sending>& sending) {
  const auto go_on = [stream, sending] { write(stream, sending); };
  const std::string& file = sending->file;
  while (sending->sent < file.size()) {
    v1::GetMeshFileResponse response;
    v1::MeshFilePart& part = *response.mutable_part();
    part.set_offset(sending->sent);
    part.set_data(file.substr(sending->sent, limits::kMeshPartBytes));
    part.set_crc32c(crc32c(part.data()));
    sending->sent += part.data().size();
    stream->send(response);
    if (stream->wait_for_client(go_on)) return;
  }
  stream->end();
}

/// For the lane of computations.
void make_file(const std::shared_ptr<MessageStream>& stream, Session& session,
               const v1::GetMeshFileRequest& request, const HeldRevisionPtr& revision) {
  const Run run{.stop = stream->stop_token(), .on_progress = {}, .dumps = {}};
  run.poll();
  auto memory = session.take_reply_memory(mesh_file_memory(*revision, request.format()), run.stop);
  const auto sending = std::make_shared<Sending>();
  sending->file = mesh_file(session, *revision, request.format(), run);
  sending->file.shrink_to_fit();
  run.poll();
  if (memory) memory.resize(limits::kUntakenBytes + sending->file.size());
  stream->keep(std::move(memory));
  v1::GetMeshFileResponse response;
  v1::MeshFileHeader& header = *response.mutable_header();
  header.set_revision(revision->record.id);
  header.set_format(request.format());
  header.set_bytes(sending->file.size());
  header.set_digest(sha256_hex(sending->file));
  stream->send(response);
  write(stream, sending);
}

}  // namespace

void send_mesh_file(const std::shared_ptr<MessageStream>& stream, Session& session,
                    const v1::GetMeshFileRequest& request) {
  check_mesh_file_format(request.format());
  work_on_revision(stream, session, request.revision(),
                   [stream, &session, request](const HeldRevisionPtr& revision) {
                     make_file(stream, session, request, revision);
                   });
}

}  // namespace remeshd
