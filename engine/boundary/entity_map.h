#pragma once

#include <optional>
#include <vector>

#include "engine/cellular/boundary_model/support.h"

namespace remeshd {

/// Where the boundary of one model is a part of another's, as away from a change: which entity of
/// the other a node stands on. Entities may have been renumbered, cut in two or joined.
class EntityMap {
 public:
  /// `tolerance`: distance within which entities are the same, length. Keeps references to both.
  EntityMap(const BoundaryModel& from, const BoundaryModel& to, double tolerance);

  /// The support in the other boundary of a node at p that stands on `support` in the first;
  /// nothing where the other has none there.
  [[nodiscard]] std::optional<Support> operator()(const Support& support, const Vec3& p) const;

 private:
  [[nodiscard]] double distance2(Support::Kind kind, int entity, const Vec3& p) const;

  const BoundaryModel& to_;
  /// By kind and entity of the first: those of the second that may be the same.
  std::array<std::vector<std::vector<int>>, 4> candidates_;
};

}  // namespace remeshd
