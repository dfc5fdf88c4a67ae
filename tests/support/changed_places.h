#pragma once

#include <cstdint>
#include <vector>

#include "engine/model/solid.h"
#include "engine/revision/revision.h"

namespace remeshd::test {

/// Where an edit changed the boundary of a model: points all over what is boundary of one of the
/// two models and of the other not, or with the material on the other side.
///
/// Points stand .36 local lengths apart at most, and a distance is less by what may lie between
/// them, so that none is told as further from a change than it is.
class ChangedPlaces {
 public:
  ChangedPlaces(const Revision& base, const Revision& edited);

  /// Whether something changed within `reach` of a point of the base's material.
  [[nodiscard]] bool within(const Vec3& p, double reach) const;
  /// From a point of the base's material to what changed; infinite where nothing did.
  [[nodiscard]] double distance_to(const Vec3& p) const;

 private:
  struct Place {
    Vec3 position;
    double slack;  ///< to the next one
  };
  void add_changes(const Revision& of, const Membership& own);

  Membership before_, after_;
  double diagonal_;
  std::vector<Place> places_;
};

/// By node of the base: whether its edit's mesh has it as it was, or as the feature was moved that
/// it was copied with.
std::vector<std::uint8_t> kept_nodes(const Revision& base, const Revision& edited);

/// Of all nodes of a base.
struct KeptShares {
  double kept = 0;
  double far = 0;  ///< further than `lengths` local lengths from what the edit changed
};
KeptShares kept_shares(const Revision& base, const Revision& edited, double lengths);

}  // namespace remeshd::test
