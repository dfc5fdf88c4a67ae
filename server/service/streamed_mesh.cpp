#include "server/service/streamed_mesh.h"

#include <memory>
#include <utility>

#include "remesh/v1/stream.pb.h"
#include "server/service/call.h"
#include "server/service/mesh_bytes.h"
#include "server/service/mesh_messages.h"
#include "server/service/status.h"
#include "server/session/catching.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

class StreamedMesh final : public ReplySource {
 public:
  StreamedMesh(std::string request_id, MeshMessages messages)
      : request_id_(std::move(request_id)), messages_(std::move(messages)) {}
  grpc::ByteBuffer next() override {
    v1::EditStreamResponse reply;
    reply.set_request_id(request_id_);
    PartData data;
    messages_.next(*reply.mutable_mesh(), data);
    return mesh_bytes(reply, data);
  }
  [[nodiscard]] bool ended() const override { return messages_.ended(); }
  [[nodiscard]] std::uint64_t own_bytes() const override { return messages_.own_bytes(); }

 private:
  const std::string request_id_;
  MeshMessages messages_;
};

/// The error that stands in the place of a mesh.
class NoMesh final : public ReplySource {
 public:
  NoMesh(const std::string& request_id, const Error& why) {
    reply_.set_request_id(request_id);
    *reply_.mutable_error() = to_message(why);
  }
  grpc::ByteBuffer next() override {
    ended_ = true;
    return to_bytes(reply_);
  }
  [[nodiscard]] bool ended() const override { return ended_; }

 private:
  v1::EditStreamResponse reply_;
  bool ended_ = false;
};

}  // namespace

ReplySourcePtr streamed_mesh(Session& session, const Made& made, const std::string& request_id,
                             const v1::MeshSelection& selection) {
  ReplySourcePtr replies;
  catching(
      [&] {
        const HeldRevisionPtr parent =
            selection.delta() ? session.parent_of(*made.revision, Run{}) : nullptr;
        replies = std::make_shared<StreamedMesh>(request_id,
                                                 MeshMessages(made.revision, parent, selection));
      },
      [&](const Error& why) { replies = std::make_shared<NoMesh>(request_id, why); });
  return replies;
}

}  // namespace remeshd
