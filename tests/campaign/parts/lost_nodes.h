#pragma once

#include <vector>

#include "engine/model/solid.h"
#include "engine/revision/revision.h"

namespace remeshd::campaign {

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
  double tiny_;  ///< beside a surface: of the diagonal
  std::vector<Place> places_;
};

/// Nodes of a base that are not in its edit's mesh as they were, or as the feature was moved that
/// they were copied with.
struct LostNodes {
  int all = 0;
  int far = 0;          ///< further than kFar local lengths of the base from what changed
  double furthest = 0;  ///< of the far ones, in local lengths; kNowhere where nothing changed
};
inline constexpr double kFar = 6;
inline constexpr double kNowhere = 1e6;

LostNodes lost_nodes(const Revision& base, const Revision& edited);

}  // namespace remeshd::campaign
