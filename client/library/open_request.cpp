// SPDX-License-Identifier: Apache-2.0
#include "client/library/open_request.h"

#include "remeshd/error.h"

namespace remeshd::client {

void OpenRequest::take_result(const remesh::v1::RevisionResult& result) {
  if (result_told_) return;
  result_told_ = true;
  result_.set_value(result);
}

void OpenRequest::take_mesh(const remesh::v1::MeshMessage& message,
                            std::shared_ptr<const Mesh>& last) {
  if (!wanted_ || mesh_told_) return;  // after a fault the rest of the mesh is passed over
  try {
    if (!assembler_)
      assembler_.emplace(wanted_->arrays,
                         std::vector<std::shared_ptr<const Mesh>>{wanted_->base, last});
    assembler_->add(message);
    if (!assembler_->ended()) return;
    const auto mesh = std::make_shared<const Mesh>(assembler_->finish());
    if (wanted_->delta) last = mesh;
    mesh_told_ = true;
    mesh_.set_value(mesh);
  } catch (...) {
    tell_mesh_error(std::current_exception());
  }
}

void OpenRequest::fail(const remesh::v1::Error& error) {
  const auto failure = std::make_exception_ptr(CallError(error));
  if (!result_told_) result_.set_exception(failure);
  result_told_ = true;
  tell_mesh_error(failure);
}

void OpenRequest::tell_mesh_error(std::exception_ptr error) {
  if (!mesh_told_) mesh_.set_exception(std::move(error));
  mesh_told_ = true;
}

}  // namespace remeshd::client
