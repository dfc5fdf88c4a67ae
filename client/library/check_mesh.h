// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>

#include "remesh/v1/remesh.pb.h"
#include "remeshd/mesh.h"

namespace remeshd::client {

/// Checks that every index in a mesh is in range. `arrays`: those that the mesh has; indices into
/// other arrays are not checked.
///
/// Throws CallError MESH_DAMAGED.
void check_mesh(const Mesh& mesh, const std::set<remesh::v1::MeshArray>& arrays);

}  // namespace remeshd::client
