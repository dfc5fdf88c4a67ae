#pragma once

#include <array>
#include <vector>

#include "engine/model/feature_model.h"

namespace remeshd {

class Scope;

/// Most entries of one profile.
inline constexpr std::size_t kMaxProfileEntries = 1000;

/// What errors call entry k (0-based) of a profile: `profile[k]`.
std::string entry_name(std::size_t k);
/// The face that side k (0-based) of a profile sweeps: `side1`, ...
std::string side_name(std::size_t k);

/// A point of the profile's plane.
using Point2 = std::array<double, 2>;

/// Axis-aligned box in the profile's plane.
struct Box2 {
  Point2 lo{HUGE_VAL, HUGE_VAL}, hi{-HUGE_VAL, -HUGE_VAL};
  void add(const Point2& p);
  [[nodiscard]] double diagonal() const;
};

/// Sides of a written profile: side k (0-based) runs from entry k to k+1, an arc belongs to the
/// side it ends, and the last side closes the loop unless the last entry returns to the first.
///
/// Throws Error(InvalidArgument) naming `profile[k]` or `profile[k].through`: too few or too many
/// entries, a first entry that is an arc, sides without length, arcs whose three points lie on a
/// line, values that are not finite or out of range, and what `check_simple` finds.
std::vector<ProfileSide> evaluate_profile(const std::vector<ProfileEntry>& entries,
                                          const Scope& scope, const std::string& feature);

/// As `evaluate_profile` for a profile of the half-plane x >= 0 that is turned about x = 0.
///
/// Coordinates within rounding of the axis are put on it. Beyond the above, throws
/// Error(PROFILE_CROSSES_AXIS) where a side reaches x < 0, where an arc touches the axis between
/// its ends, and, for a full turn, where a corner alone touches it: the solid would pinch to a
/// point.
std::vector<ProfileSide> evaluate_half_profile(const std::vector<ProfileEntry>& entries,
                                               bool full_turn, const Scope& scope,
                                               const std::string& feature);

/// Length below which two points of a profile count as one: 1e-9 x its extent.
double profile_tolerance(const std::vector<ProfileSide>& sides);

/// Throws Error(SELF_INTERSECTING_PROFILE) where two sides meet anywhere but at their common end,
/// or leave it in the same direction.
void check_simple(const std::vector<ProfileSide>& sides, const std::string& feature);

Box2 side_bounds(const ProfileSide& side);
Box2 profile_bounds(const std::vector<ProfileSide>& sides);

/// Angle an arc turns through, in (-2 pi, 2 pi), positive counter-clockwise.
double sweep(const ProfileSide& arc);

/// Area enclosed, positive if the sides run counter-clockwise.
double signed_area(const std::vector<ProfileSide>& sides);

/// First moment of the enclosed area about x = 0, the integral of x dA; signed as `signed_area`.
double moment_about_axis(const std::vector<ProfileSide>& sides);

}  // namespace remeshd
