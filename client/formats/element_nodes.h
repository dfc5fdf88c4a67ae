// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "remeshd/mesh.h"

namespace remeshd::client {

// Files number mid-nodes after all corner nodes.

inline bool is_second_order(const Mesh& mesh) { return !mesh.tet_mids.empty(); }

/// The nodes of a tet: its corners, then mid-nodes, in the order of `Mesh::tet_mids`.
std::vector<std::int32_t> nodes_of(const Mesh& mesh, std::size_t tet);

/// Likewise of a facet.
std::vector<std::int32_t> nodes_of(const Mesh& mesh, const Facet& facet);

/// The edge lengths aimed at, by node; mid-nodes have the mean of their corners'. None of an even
/// mesh.
std::vector<double> sizes_of(const Mesh& mesh);

}  // namespace remeshd::client
