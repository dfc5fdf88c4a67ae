#include "engine/model/profile.h"

#include <cmath>
#include <string>

#include "engine/base/error.h"
#include "engine/model/expression.h"
#include "engine/model/limits.h"

namespace remeshd {

std::string side_name(std::size_t k) { return "side" + std::to_string(k + 1); }

std::string entry_name(std::size_t k) { return "profile[" + std::to_string(k) + "]"; }

namespace {

double separation(const Point2& a, const Point2& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

/// The entries as numbers.
struct Entry {
  Point2 at{};
  std::optional<Point2> through;
};

std::vector<Entry> evaluate_entries(const std::vector<ProfileEntry>& entries, const Scope& scope,
                                    const std::string& feature) {
  if (entries.size() > kMaxProfileEntries)
    throw error::limit_exceeded(feature, "profile", "profile entries", entries.size(),
                                kMaxProfileEntries);
  if (entries.size() < 2)
    throw error::invalid_profile(feature, "profile", "has fewer than two entries",
                                 "an outline needs three points, or two where one side is an arc");
  if (entries.front().through)
    throw error::invalid_profile(feature, entry_name(0), "is an arc",
                                 "start with a point; an arc may come last and return to it");
  std::vector<Entry> result;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const std::string place = entry_name(k);
    const auto coordinate = [&](const Scalar& s, const std::string& where) {
      return checked_coordinate(scope.value(s, feature, where), feature, where);
    };
    Entry entry{{coordinate(entries[k].x, place), coordinate(entries[k].y, place)}, {}};
    if (const auto& through = entries[k].through)
      entry.through = Point2{coordinate((*through)[0], place + ".through"),
                             coordinate((*through)[1], place + ".through")};
    result.push_back(entry);
  }
  return result;
}

/// Makes an arc of a side whose ends are set. Throws if the three points lie on a line.
void bend(ProfileSide& side, const Point2& through, const std::string& feature,
          const std::string& place) {
  const double ax = side.to[0] - side.from[0], ay = side.to[1] - side.from[1];
  const double bx = through[0] - side.from[0], by = through[1] - side.from[1];
  const double chord = std::hypot(ax, ay);
  const double twice_area = ax * by - ay * bx;
  // Flatter than this the centre lies so far off that it has no digits left.
  if (std::fabs(twice_area) <= 1e-6 * chord * chord ||
      std::fabs(twice_area) <= 1e-6 * chord * std::hypot(bx, by))
    throw error::invalid_profile(feature, place, "lies on a line with the ends of its arc",
                                 "write the side as a plain point, or move the point off the line");
  const double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by;
  const double ux = (by * a2 - ay * b2) / (2 * twice_area);
  const double uy = (ax * b2 - bx * a2) / (2 * twice_area);
  side.arc = true;
  side.centre = {side.from[0] + ux, side.from[1] + uy};
  side.radius = std::hypot(ux, uy);
  // The arc passes to the right of its chord if and only if it turns counter-clockwise.
  side.counter_clockwise = twice_area < 0;
}

std::vector<ProfileSide> join(const std::vector<Entry>& entries, const std::string& feature) {
  Box2 extent;
  for (const Entry& entry : entries) {
    extent.add(entry.at);
    if (entry.through) extent.add(*entry.through);
  }
  const double tolerance = 1e-9 * extent.diagonal();
  const bool returns =
      entries.size() > 2 && separation(entries.back().at, entries.front().at) <= tolerance;
  const std::size_t count = returns ? entries.size() - 1 : entries.size();
  std::vector<ProfileSide> sides(count);
  bool any_arc = false;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t end = k + 1 < entries.size() ? k + 1 : 0;
    sides[k].from = entries[k].at;
    sides[k].to = k + 1 < count ? entries[end].at : entries[0].at;
    if (separation(sides[k].from, sides[k].to) <= tolerance)
      throw error::invalid_profile(feature, entry_name(end == 0 ? k : end),
                                   "ends a side that has no length",
                                   "leave out points that repeat their neighbour");
    if (!entries[end].through) continue;
    any_arc = true;
    bend(sides[k], *entries[end].through, feature, entry_name(end) + ".through");
  }
  if (count < (any_arc ? 2U : 3U))
    throw error::invalid_profile(feature, "profile", "has too few sides to enclose an area",
                                 "an outline needs three sides, or two where one is an arc");
  return sides;
}

}  // namespace

std::vector<ProfileSide> evaluate_profile(const std::vector<ProfileEntry>& entries,
                                          const Scope& scope, const std::string& feature) {
  std::vector<ProfileSide> sides = join(evaluate_entries(entries, scope, feature), feature);
  check_simple(sides, feature);
  return sides;
}

std::vector<ProfileSide> evaluate_half_profile(const std::vector<ProfileEntry>& entries,
                                               bool full_turn, const Scope& scope,
                                               const std::string& feature) {
  std::vector<Entry> points = evaluate_entries(entries, scope, feature);
  Box2 extent;
  for (const Entry& entry : points) extent.add(entry.at);
  const double tolerance = 1e-9 * extent.diagonal();
  for (std::size_t k = 0; k < points.size(); ++k) {
    double& x = points[k].at[0];
    if (x < -tolerance) throw error::profile_crosses_axis(feature, entry_name(k), "lies at x < 0");
    if (x <= tolerance) x = 0;
  }
  std::vector<ProfileSide> sides = join(points, feature);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const ProfileSide& side = sides[k];
    if (!side.arc) continue;
    const double left = side_bounds(side).lo[0];
    const bool at_end = side.from[0] == 0 || side.to[0] == 0;
    if (left < -tolerance || (!at_end && left <= tolerance))
      throw error::profile_crosses_axis(feature, entry_name((k + 1) % points.size()),
                                        "ends an arc that reaches the axis between its ends");
  }
  check_simple(sides, feature);
  const auto on_axis = [](const ProfileSide& s) {
    return !s.arc && s.from[0] == 0 && s.to[0] == 0;
  };
  for (std::size_t k = 0; full_turn && k < sides.size(); ++k) {
    const ProfileSide& before = sides[(k + sides.size() - 1) % sides.size()];
    if (sides[k].from[0] == 0 && !on_axis(sides[k]) && !on_axis(before))
      throw error::profile_crosses_axis(feature, entry_name(k),
                                        "touches the axis with a corner alone, which pinches the "
                                        "solid to a point");
  }
  return sides;
}

}  // namespace remeshd
