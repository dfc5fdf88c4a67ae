// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/support/sync_stream.h>

#include <chrono>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "client/library/call_context.h"
#include "client/library/farm.h"
#include "client/library/open_request.h"
#include "client/library/search.h"
#include "remesh/v1/remesh.grpc.pb.h"
#include "remeshd/edit_stream.h"

namespace remeshd::client {

/// The state behind an EditStream.
///
/// Inv: every request that is not answered yet, sent or waiting to be sent, is in `unanswered_`;
/// the reading thread answers it, or, when the stream ends, gives all of them the stream's error.
/// Only that thread takes out a request that was sent; `cancel` takes out one that was not. The
/// first request opens the stream, for its route tells the replica.
struct EditStream::Impl {
  Impl(std::shared_ptr<Farm> farm, OnProgress listener, const CallOptions& call);
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Answers edit(remesh::v1::EditRevisionRequest request, std::optional<MeshWanted> mesh);
  Answers create(remesh::v1::CreateRevisionRequest request, std::optional<MeshWanted> mesh);
  void cancel(const std::string& request_id);
  void cancel_all();
  void finish();

 private:
  /// One call of EditStream; a stream that broke goes on in another one, perhaps of another
  /// replica.
  struct Call {
    explicit Call(const Search& search)
        : replica(search.replica()),
          context(search.rest(), replica, search.route()),
          stream(replica.service().EditStream(context.get())) {}
    Replica& replica;
    CallContext context;
    std::unique_ptr<
        grpc::ClientReaderWriter<remesh::v1::EditStreamRequest, remesh::v1::EditStreamResponse>>
        stream;
    bool used = false;  ///< something was sent
    bool writes_done = false;
  };
  struct Unanswered {
    std::string id;
    remesh::v1::EditStreamRequest message;
    OpenRequest request;
    std::optional<remesh::v1::RevisionResult> result{};  ///< set while its mesh is still to come
    bool sent = false;                                   ///< in the present call
    bool sent_before = false;                            ///< in a call that broke
    bool cancelled = false;                              ///< so it is not sent again
  };
  using Requests = std::list<Unanswered>;

  Answers send(const std::string& id, remesh::v1::EditStreamRequest request,
               std::optional<MeshWanted> mesh);
  void open(const remesh::v1::EditStreamRequest& first);
  [[nodiscard]] std::string route_of_first(const remesh::v1::EditStreamRequest& first) const;
  [[nodiscard]] CallOptions rest() const;
  std::string fresh_id();
  Requests::iterator find(const std::string& id);
  [[nodiscard]] std::optional<remesh::v1::EditStreamRequest> to_send(const Unanswered& next);
  bool first_is_lost() const;
  void send_waiting();
  void read();
  [[nodiscard]] bool moves_on(Call& from, const remesh::v1::EditStreamResponse& response);
  void take(Call& from, const remesh::v1::EditStreamResponse& response);
  [[nodiscard]] bool is_over();
  [[nodiscard]] Requests take_cancelled();
  bool reopen(bool refused);
  void end_with(const grpc::Status& status);

  const std::shared_ptr<Farm> farm_;
  const OnProgress on_progress_;
  const CallOptions options_;
  const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::shared_ptr<const Mesh> last_mesh_;  ///< of the last request with `delta`; reading thread's

  std::mutex writing_;  ///< one write at a time; taken before `state_`
  std::mutex state_;    ///< guards what follows
  /// Null before the first request; then used by the reading thread alone, but for `stop`.
  std::unique_ptr<Search> search_;
  std::shared_ptr<Call> call_;
  Requests unanswered_;                             ///< in the order of their requests
  std::optional<remesh::v1::RevisionResult> last_;  ///< of the requests that are done
  bool closed_ = false;                             ///< no more requests
  bool cancelled_ = false;
  std::optional<remesh::v1::Error> end_;  ///< set once the stream has ended: what late requests get
  bool ended_well_ = false;
  std::uint64_t next_id_ = 1;
  std::thread reader_;
};

}  // namespace remeshd::client
