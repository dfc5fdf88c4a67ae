#pragma once

#include <cstdint>

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// What a node stands on: the vertex, edge or face of the model's boundary that variational
/// tetrahedral meshing has put it on, or the interior.
struct Support {
  enum class Kind : std::uint8_t { Interior, Face, Edge, Vertex };
  Kind kind = Kind::Interior;
  std::int32_t entity = -1;  ///< index in BoundaryModel::faces, edges or vertices
  friend bool operator==(const Support&, const Support&) = default;
};

/// Nearest point of the curve of an edge (within its ends).
Vec3 project(const BoundaryModel& boundary, const BoundaryEdge& edge, const Vec3& p);

/// The place nearest to p that a node with this support may have: p itself in the interior, the
/// nearest point of the untrimmed surface of its face or of the curve of its edge, or its vertex.
Vec3 project(const BoundaryModel& boundary, const Support& support, const Vec3& p);

/// Whether an entity bounds another or is the same: a face and its edges, an edge and its vertices,
/// a face and the vertices of its edges. The order does not matter.
bool incident(const BoundaryModel& boundary, const Support& a, const Support& b);

}  // namespace remeshd
