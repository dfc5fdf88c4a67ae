// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "remesh/v1/mesh.pb.h"

namespace remeshd::client {

/// Puts a mesh file together from the messages of a GetMeshFile. Everything is checked: order,
/// CRC-32C of each part, length and digest of the whole.
class MeshFileAssembler {
 public:
  /// Throws CallError MESH_DAMAGED.
  void add(const remesh::v1::GetMeshFileResponse& message);
  /// The file; nothing is left here. Throws CallError MESH_DAMAGED where it is not complete.
  std::string finish();
  /// Forgets all, for a transfer from the start.
  void restart() { *this = {}; }

  [[nodiscard]] std::uint64_t bytes_received() const { return file_.size(); }
  [[nodiscard]] std::uint64_t bytes_expected() const { return header_.bytes(); }

 private:
  bool has_header_ = false;
  remesh::v1::MeshFileHeader header_;
  std::string file_;
};

}  // namespace remeshd::client
