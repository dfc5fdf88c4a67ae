// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/support/sync_stream.h>

#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "client/library/call_context.h"
#include "client/library/open_request.h"
#include "remesh/v1/remesh.grpc.pb.h"
#include "remeshd/edit_stream.h"

namespace remeshd::client {

/// The state behind an EditStream.
///
/// Inv: every request sent and not yet answered is in `open`; the reading thread answers it, or,
/// when the stream ends, gives all of them the stream's error. Only that thread takes one out.
struct EditStream::Impl {
  Impl(remesh::v1::RemeshService::Stub& stub, OnProgress listener, const CallOptions& call,
       const std::string& token);
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Answers edit(remesh::v1::EditRevisionRequest request, std::optional<MeshWanted> mesh);
  Answers create(remesh::v1::CreateRevisionRequest request, std::optional<MeshWanted> mesh);
  Answers send(const std::string& id, remesh::v1::EditStreamRequest request,
               std::optional<MeshWanted> mesh);
  std::string fresh_id();
  void read();
  void take(const remesh::v1::EditStreamResponse& response);

  CallContext context;
  OnProgress on_progress;
  std::unique_ptr<
      grpc::ClientReaderWriter<remesh::v1::EditStreamRequest, remesh::v1::EditStreamResponse>>
      stream;
  std::shared_ptr<const Mesh> last_mesh;  ///< that the stream brought; of the reading thread

  std::mutex writing;  ///< one write at a time; guards `closed`
  bool closed = false;
  std::mutex state;  ///< guards what follows
  std::map<std::string, OpenRequest> open;
  std::optional<remesh::v1::Error> end;  ///< set once the stream has ended: what late requests get
  bool ended_well = false;
  std::uint64_t next_id = 1;
  std::thread reader;
};

}  // namespace remeshd::client
