// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <grpcpp/support/sync_stream.h>

#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "client/library/call_context.h"
#include "remesh/v1/remesh.grpc.pb.h"
#include "remeshd/edit_stream.h"

namespace remeshd::client {

/// The state behind an EditStream.
///
/// Inv: every request sent and not yet answered has a promise in `open`; the reading thread answers
/// it, or, when the stream ends, gives all of them the stream's error.
struct EditStream::Impl {
  Impl(remesh::v1::Remesh::Stub& stub, OnProgress listener, const CallOptions& call);
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  std::future<remesh::v1::RevisionReply> send(const std::string& id,
                                              const remesh::v1::EditStreamRequest& request);
  std::string fresh_id();
  void read();

  CallContext context;
  OnProgress on_progress;
  std::unique_ptr<
      grpc::ClientReaderWriter<remesh::v1::EditStreamRequest, remesh::v1::EditStreamReply>>
      stream;

  std::mutex writing;  ///< one write at a time; guards `closed`
  bool closed = false;
  std::mutex state;  ///< guards what follows
  std::map<std::string, std::promise<remesh::v1::RevisionReply>> open;
  std::optional<remesh::v1::Error> end;  ///< set once the stream has ended: what late requests get
  bool ended_well = false;
  std::uint64_t next_id = 1;
  std::thread reader;
};

}  // namespace remeshd::client
