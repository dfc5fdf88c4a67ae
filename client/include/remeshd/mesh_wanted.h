// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "remesh/v1/remesh.pb.h"
#include "remeshd/mesh.h"

namespace remeshd::client {

/// What of a mesh to send, and how.
struct MeshWanted {
  std::vector<remesh::v1::MeshArray>
      arrays{};  ///< none: all; what is left out is empty in the Mesh
  /// Send what differs from the mesh of the revision's parent, where that is shorter. The Mesh is
  /// the same, to the bit.
  bool delta = false;
  /// With `delta`: the parent's mesh, with the same arrays. In a stream, null means the mesh of the
  /// last request with `delta`, which the stream keeps for this purpose.
  std::shared_ptr<const Mesh> base{};
};

}  // namespace remeshd::client
