// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>

#include "remesh/v1/remesh.pb.h"
#include "remeshd/mesh.h"

namespace remeshd::client {

/// Checks that every index of a mesh that has these arrays leads to something that is there. One
/// into an array that the mesh has not is not looked at.
///
/// Throws CallError MESH_DAMAGED.
void check_mesh(const Mesh& mesh, const std::set<remesh::v1::MeshArray>& arrays);

}  // namespace remeshd::client
