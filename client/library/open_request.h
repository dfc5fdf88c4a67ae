// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <future>
#include <memory>
#include <optional>

#include "client/library/mesh_assembler.h"
#include "remesh/v1/remesh.pb.h"
#include "remeshd/edit_stream.h"
#include "remeshd/mesh_wanted.h"

namespace remeshd::client {

/// A request that is not answered yet. Each promise is kept once: by what came, or by an error.
class OpenRequest {
 public:
  explicit OpenRequest(std::optional<MeshWanted> mesh) : wanted_(std::move(mesh)) {}
  EditStream::Answers answers() { return {result_.get_future(), mesh_.get_future()}; }

  void take_result(const remesh::v1::RevisionResult& result);
  /// `last`: the mesh that the stream keeps as a base; replaced by this one where deltas are
  /// wanted. What is wrong with the mesh goes to its future.
  void take_mesh(const remesh::v1::MeshMessage& message, std::shared_ptr<const Mesh>& last);
  /// Forgets what of the mesh has come: the request is sent again.
  void restart() { assembler_.reset(); }
  /// Gives what is still open this error.
  void fail(const remesh::v1::Error& error);
  /// Whether nothing more comes after this answer.
  [[nodiscard]] bool is_last(const remesh::v1::EditStreamResponse& answer) const {
    return answer.has_error() || (wanted_ ? answer.mesh().has_end() : answer.has_result());
  }

 private:
  void tell_mesh_error(std::exception_ptr error);

  std::optional<MeshWanted> wanted_;
  std::promise<remesh::v1::RevisionResult> result_;
  std::promise<std::shared_ptr<const Mesh>> mesh_;
  std::optional<MeshAssembler> assembler_;
  bool result_told_ = false;
  bool mesh_told_ = false;  ///< the mesh, or why there is none
};

}  // namespace remeshd::client
