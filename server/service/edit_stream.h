#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>

#include "remesh/v1/remesh.pb.h"
#include "server/service/call.h"
#include "server/session/session.h"

namespace remeshd {

/// One EditStream. Requests queue up and are handed to the session one at a time, so that an edit
/// sees the head that the one before it left, and answers keep their order.
class EditStream final : public grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>,
                         public std::enable_shared_from_this<EditStream> {
 public:
  static EditStream* start(Session& session, std::size_t message_limit,
                           std::shared_ptr<CallRecord> record);
  /// Use `start`.
  EditStream(Session& session, std::size_t message_limit, std::shared_ptr<CallRecord> record);

  void OnReadDone(bool ok) override;
  void OnWriteDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

 private:
  using Command = std::variant<CreateCommand, EditCommand, Error>;
  struct Waiting {
    std::string id;
    Command command;
    std::size_t bytes = 0;
    bool cancelled = false;
  };

  void take(const grpc::ByteBuffer& bytes);
  void cancel_by_id(const std::string& id);
  void pump();
  void launch(Waiting request);
  void answer(const std::string& id, remesh::v1::EditStreamReply reply);
  void progress(std::uint64_t turn, const std::string& id, const Progress& progress);
  void write_next();
  void read_more();
  void finish_if_done();
  [[nodiscard]] bool full() const;

  Session& session_;
  const std::size_t message_limit_;
  const std::shared_ptr<CallRecord> record_;
  std::shared_ptr<EditStream> self_;

  // Touched by the one reading or writing only.
  grpc::ByteBuffer incoming_, outgoing_;

  std::mutex mutex_;
  std::deque<Waiting> waiting_;
  std::size_t waiting_bytes_ = 0;
  bool pumping_ = false;
  bool busy_ = false;       ///< a request is with the session
  std::uint64_t turn_ = 0;  ///< number of that request
  std::string at_work_;     ///< its id
  MakeRequestPtr request_;  ///< null until the session has returned it
  bool cancel_at_work_ = false;
  std::string design_;  ///< of the last request that named or found one
  std::deque<remesh::v1::EditStreamReply> replies_;
  bool writing_ = false;
  bool reading_ = false;
  bool reads_done_ = false;
  bool cancelled_ = false;
  bool finished_ = false;
  std::uint64_t answered_ = 0, failed_ = 0;
};

}  // namespace remeshd
