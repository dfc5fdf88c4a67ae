// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "client/library/array_shape.h"
#include "remesh/v1/remesh.pb.h"
#include "remeshd/mesh.h"

namespace remeshd::client {

/// What the rows of an array belong to: there is one for each.
enum class RowOf { Node, Tet, Facet, MidNode, Other };

/// One array of the protocol and its place in a Mesh.
struct KnownArray {
  remesh::v1::MeshArray array;
  ArrayShape shape;
  RowOf row_of;
  /// Fills the place from the array's bytes, of whole rows. Throws CallError MESH_DAMAGED.
  void (*read)(std::string_view bytes, Mesh& mesh);
  /// The array's bytes, as they travel.
  std::string (*write)(const Mesh& mesh);
};

/// Every array that a Mesh has a place for; each mesh of the daemon has all of them, but for the
/// groups of a model without any, the sizes of an even one and the mid-nodes of one of first order.
std::span<const KnownArray> known_arrays();

/// The entry of an array, or nullptr for one that a Mesh has no place for.
const KnownArray* find_array(remesh::v1::MeshArray array);

}  // namespace remeshd::client
