#include "tests/bench/peers/gmsh_geometry.h"

#include <gmsh.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace remeshd::bench {
namespace {

namespace occ = gmsh::model::occ;
using DimTags = gmsh::vectorpair;

/// A face in the plane of two local axes, bounded by a profile.
int profile_face(const std::vector<ProfileSide>& sides, bool in_xz) {
  const auto point = [&](const std::array<double, 2>& p) {
    return in_xz ? occ::addPoint(p[0], 0, p[1]) : occ::addPoint(p[0], p[1], 0);
  };
  std::vector<int> corners, curves;
  corners.reserve(sides.size());
  for (const ProfileSide& side : sides) corners.push_back(point(side.from));
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const ProfileSide& side = sides[k];
    const int from = corners[k], to = corners[(k + 1) % corners.size()];
    if (!side.arc) {
      curves.push_back(occ::addLine(from, to));
      continue;
    }
    // Gmsh's arcs are shorter than half a turn: two of them, by way of the middle.
    const auto angle = [&](const std::array<double, 2>& p) {
      return std::atan2(p[1] - side.centre[1], p[0] - side.centre[0]);
    };
    double turn = angle(side.to) - angle(side.from);
    if (side.counter_clockwise && turn <= 0) turn += 2 * std::numbers::pi;
    if (!side.counter_clockwise && turn >= 0) turn -= 2 * std::numbers::pi;
    const double half = angle(side.from) + 0.5 * turn;
    const int centre = point(side.centre);
    const int middle = point({side.centre[0] + side.radius * std::cos(half),
                              side.centre[1] + side.radius * std::sin(half)});
    curves.push_back(occ::addCircleArc(from, centre, middle));
    curves.push_back(occ::addCircleArc(middle, centre, to));
  }
  return occ::addPlaneSurface({occ::addCurveLoop(curves)});
}

/// The volume among what an extrusion gives.
int volume_of_result(const DimTags& made) {
  for (const auto& [dim, tag] : made)
    if (dim == 3) return tag;
  throw std::runtime_error("Gmsh made no volume of a profile");
}

/// The shape in its own frame.
struct LocalSolid {
  int operator()(const Block& s) const {
    return occ::addBox(-0.5 * s.dx, -0.5 * s.dy, 0, s.dx, s.dy, s.dz);
  }
  int operator()(const Cylinder& s) const {
    return occ::addCylinder(0, 0, 0, 0, 0, s.height, s.radius);
  }
  int operator()(const Cone& s) const {
    return occ::addCone(0, 0, 0, 0, 0, s.height, s.radius_bottom, s.radius_top);
  }
  int operator()(const Sphere& s) const { return occ::addSphere(0, 0, 0, s.radius); }
  int operator()(const Torus& s) const {
    return occ::addTorus(0, 0, 0, s.major_radius, s.minor_radius);
  }
  int operator()(const Prism& s) const {
    DimTags made;
    occ::extrude({{2, profile_face(s.profile, false)}}, 0, 0, s.height, made);
    return volume_of_result(made);
  }
  int operator()(const Revolution& s) const {
    DimTags made;
    occ::revolve({{2, profile_face(s.profile, true)}}, 0, 0, 0, 0, 0, 1, s.angle, made);
    return volume_of_result(made);
  }
  int operator()(const Slot& s) const {
    const double x = 0.5 * (s.length - s.width), r = 0.5 * s.width;
    const ProfileSide bottom{{-x, -r}, {x, -r}}, top{{x, r}, {-x, r}};
    const ProfileSide right{{x, -r}, {x, r}, true, {x, 0}, r, true};
    const ProfileSide left{{-x, r}, {-x, -r}, true, {-x, 0}, r, true};
    return (*this)(Prism{{bottom, right, top, left}, s.height});
  }
};

/// Puts a volume where its feature is: a turn about an axis, and a shift.
void place(int volume, const Transform& where) {
  const auto& m = where.m;
  const DimTags it{{3, volume}};
  const Vec3 twice_sine{m[9] - m[6], m[2] - m[8], m[4] - m[1]};
  const double cosine = 0.5 * (m[0] + m[5] + m[10] - 1);
  const double angle = std::atan2(0.5 * norm(twice_sine), cosine);
  if (angle > 1e-14) {
    Vec3 axis = twice_sine;
    if (norm(twice_sine) < 1e-6) {
      // Half a turn: R = 2 a aT - 1, so the largest column of R + 1 lies along the axis.
      const Vec3 x{m[0] + 1, m[4], m[8]}, y{m[1], m[5] + 1, m[9]}, z{m[2], m[6], m[10] + 1};
      axis = norm2(x) >= norm2(y) && norm2(x) >= norm2(z) ? x : norm2(y) >= norm2(z) ? y : z;
    }
    occ::rotate(it, 0, 0, 0, axis.x, axis.y, axis.z, angle);
  }
  if (m[3] != 0 || m[7] != 0 || m[11] != 0) occ::translate(it, m[3], m[7], m[11]);
}

}  // namespace

int build_merged_solid(const FeatureModel& model) {
  gmsh::option::setNumber("Geometry.OCCUnionUnify", 1);
  DimTags solid;
  for (const Feature& feature : model.features) {
    const bool additive = feature.nature == Nature::Additive;
    if (solid.empty() && !additive) continue;
    const int tool = std::visit(LocalSolid{}, feature.shape);
    place(tool, feature.placement);
    if (solid.empty()) {
      solid = {{3, tool}};
      continue;
    }
    DimTags result;
    std::vector<DimTags> history;
    if (additive)
      occ::fuse(solid, {{3, tool}}, result, history);
    else
      occ::cut(solid, {{3, tool}}, result, history);
    solid = result;
  }
  occ::synchronize();
  if (solid.size() != 1 || solid.front().first != 3)
    throw std::runtime_error("the merged solid is in " + std::to_string(solid.size()) + " pieces");
  // Points and centres of profiles that nothing uses.
  DimTags loose;
  gmsh::model::getEntities(loose, 0);
  DimTags bound;
  gmsh::model::getBoundary(solid, bound, false, false, /*recursive=*/true);
  DimTags unused;
  for (const auto& entity : loose)
    if (std::find(bound.begin(), bound.end(), entity) == bound.end()) unused.push_back(entity);
  if (!unused.empty()) {
    occ::remove(unused);
    occ::synchronize();
  }
  return solid.front().second;
}

}  // namespace remeshd::bench
