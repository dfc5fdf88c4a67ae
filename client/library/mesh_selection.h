// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "remesh/v1/remesh.pb.h"
#include "remeshd/mesh_wanted.h"

namespace remeshd::client {

/// What is wanted, as a request says it.
inline remesh::v1::MeshSelection to_message(const MeshWanted& wanted) {
  remesh::v1::MeshSelection selection;
  for (const remesh::v1::MeshArray array : wanted.arrays) selection.add_arrays(array);
  selection.set_delta(wanted.delta);
  return selection;
}

}  // namespace remeshd::client
