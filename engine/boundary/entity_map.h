#pragma once

#include <optional>
#include <vector>

#include "engine/cellular/boundary_model/support.h"

namespace remeshd {

/// Translates the supports of nodes from the boundary of one model into that of another where the
/// two coincide, as away from a change. Entities may have been renumbered, cut in two or joined.
class EntityMap {
 public:
  /// `tolerance`: distance within which entities are the same, length. Keeps a reference to `to`.
  EntityMap(const BoundaryModel& from, const BoundaryModel& to, double tolerance);

  /// The support that a node at p with `support` in the boundary `from` has in the boundary `to`;
  /// std::nullopt where no entity of `to` coincides with that of `support`.
  [[nodiscard]] std::optional<Support> operator()(const Support& support, const Vec3& p) const;

 private:
  [[nodiscard]] double distance2(Support::Kind kind, int entity, const Vec3& p) const;

  const BoundaryModel& to_;
  /// By kind and entity of the first: those of the second that may be the same.
  std::array<std::vector<std::vector<int>>, 4> candidates_;
};

}  // namespace remeshd
