// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <string>

#include "remesh/v1/remesh.pb.h"
#include "remeshd/mesh.h"
#include "remeshd/mesh_wanted.h"

namespace remeshd::client {

/// The loop of an optimiser over one stream: requests in, revisions out, in the order sent.
///
/// Requests may be sent ahead of their answers. Answers are read on a thread of the stream's own,
/// so a caller that computes between two edits keeps the connection alive. All functions may be
/// called from any thread.
///
/// Where the connection breaks, or the daemon starts anew, the stream is opened again, of several
/// daemons at the next in rank, and requests without an answer are sent again, edits of the head
/// with what the last result tells of it as their base: what a daemon has done already it answers
/// from its cache, or from the tier, and no head moves twice. An edit of the head of a design
/// cannot be sent again unless the last result is of that design: it may have moved the head
/// already. The first request decides which daemon the stream goes to.
class EditStream {
 public:
  /// Called on the reading thread: the id of the request and how far it is. Must not block for
  /// long, and must not throw: an exception ends the process.
  using OnProgress =
      std::function<void(const std::string& request_id, const remesh::v1::Progress&)>;

  /// The answers to a request that asked for its mesh too. Where the request fails, both throw its
  /// error; where only the mesh cannot be sent or arrives damaged, `mesh` alone does, and
  /// `Client::get_mesh` fetches it.
  struct Answers {
    std::future<remesh::v1::RevisionResult> result;
    std::future<std::shared_ptr<const Mesh>> mesh;
  };

  struct Impl;
  explicit EditStream(std::unique_ptr<Impl> impl);
  EditStream(EditStream&&) noexcept;
  EditStream& operator=(EditStream&&) noexcept;
  /// Cancels what is still under way.
  ~EditStream();

  /// Sends an edit. An empty `request_id` is filled in; an empty `base` means the head of `design`,
  /// or, where that is empty too, of the design of the last result (that result itself where it is
  /// in no design).
  ///
  /// The future throws CallError: the error of this request, after which the stream goes on, or
  /// that of the whole stream if it broke. A request with a document of more than 4 MiB is not
  /// sent: DOCUMENT_TOO_LARGE. Throws std::invalid_argument for a request id under way,
  /// std::logic_error after `finish`.
  std::future<remesh::v1::RevisionResult> edit(remesh::v1::EditRevisionRequest request);
  /// Sends a model to mesh; otherwise as `edit`.
  std::future<remesh::v1::RevisionResult> create(remesh::v1::CreateRevisionRequest request);

  /// The same, and the mesh comes in the stream, checked as `Client::get_mesh` does.
  Answers edit(remesh::v1::EditRevisionRequest request, MeshWanted mesh);
  Answers create(remesh::v1::CreateRevisionRequest request, MeshWanted mesh);

  /// Asks the daemon to cancel a request of this stream; its future throws CANCELLED, in its turn
  /// or, if the request was not sent yet, at once. A cancelled request is not sent again after a
  /// break. Does nothing once `finish` was called: `cancel_all` still works then.
  void cancel(const std::string& request_id);
  /// Cancels the whole stream: every open future throws CANCELLED or, where the connection was
  /// broken at that moment, the error of the break (UNAVAILABLE).
  void cancel_all();
  /// Sends no more, and waits until all that was sent is answered. Throws CallError if the stream
  /// broke before that.
  void finish();

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace remeshd::client
