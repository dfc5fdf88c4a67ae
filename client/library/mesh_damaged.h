// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "remesh/v1/remesh.pb.h"

namespace remeshd::client {

/// Throws CallError DATA_LOSS, MESH_DAMAGED: `what` is wrong with a mesh as it arrived.
[[noreturn]] void mesh_damaged(const std::string& what);

/// `NODES`, for messages.
std::string name_of(remesh::v1::MeshArray array);

}  // namespace remeshd::client
