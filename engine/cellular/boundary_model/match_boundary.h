#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/cellular/boundary_model/support.h"

namespace remeshd {

/// For each vertex, edge and face of one boundary its counterpart in another, by index.
struct BoundaryMatch {
  std::vector<std::int32_t> vertices, edges, faces;

  /// The same support in the other boundary.
  [[nodiscard]] Support operator()(const Support& support) const;
};

/// Where a point of an entity of the one boundary is expected on the other.
using ExpectedPlace = std::function<Vec3(const Support& entity, const Vec3& p)>;

/// Pairs the entities of two boundaries of nearly the same shape: every vertex with one at most
/// `reach` away, every edge with one between the same vertices, of the same kind and at most
/// `reach` away, every face with one of the same names, the same kind and between the same edges.
/// Distances are from where `expected` says; empty: from where an entity was.
///
/// Post: nullopt unless all entities of both are paired one to one and incidences agree, so that
/// the boundaries have the same topology.
std::optional<BoundaryMatch> match_boundaries(const BoundaryModel& from, const BoundaryModel& to,
                                              double reach, const ExpectedPlace& expected = {});

}  // namespace remeshd
