#include "engine/sizing/size_controls.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace remeshd {

namespace {

using Selected = std::vector<SizedFaces>;

/// The length asked for on a face of the boundary; infinite where it is not selected.
double asked_on(const BoundaryFace& face, const Selected& selected) {
  double size = HUGE_VAL;
  for (const FaceName& name : face.names) {
    const auto of_feature =
        std::ranges::lower_bound(selected, name.feature, {}, &SizedFaces::feature);
    if (of_feature == selected.end() || of_feature->feature != name.feature) continue;
    if (std::ranges::find(of_feature->faces, name.face) != of_feature->faces.end())
      size = std::fmin(size, of_feature->size);
  }
  return size;
}

/// What of the box lies below the plane of its top is all of it.
SizeSource source_of(const SizedBox& box) {
  return {.piece = Surface{Surface::Kind::Plane, Transform::translation(box.hi), 0, 0},
          .box = {box.lo, box.hi},
          .size = box.size,
          .asked = true,
          .filled = true};
}

}  // namespace

SizeSource size_source(const SizedBall& ball) {
  const Vec3 reach{ball.radius, ball.radius, ball.radius};
  return {
      .piece = Surface{Surface::Kind::Sphere, Transform::translation(ball.centre), ball.radius, 0},
      .box = {ball.centre - reach, ball.centre + reach},
      .size = ball.size,
      .asked = true,
      .filled = true};
}

std::vector<SizeSource> size_sources(const std::vector<SizeControl>& sizes,
                                     const BoundaryModel& boundary) {
  std::vector<double> on(boundary.faces.size(), HUGE_VAL);
  std::vector<SizeSource> sources;
  for (const SizeControl& control : sizes) {
    if (const auto* selected = std::get_if<Selected>(&control.place)) {
      for (std::size_t f = 0; f < on.size(); ++f)
        on[f] = std::fmin(on[f], asked_on(boundary.faces[f], *selected));
    } else if (const auto* ball = std::get_if<SizedBall>(&control.place)) {
      sources.push_back(size_source(*ball));
    } else {
      sources.push_back(source_of(std::get<SizedBox>(control.place)));
    }
  }
  for (std::size_t f = 0; f < on.size(); ++f)
    if (std::isfinite(on[f]))
      sources.push_back({.piece = boundary.faces[f].surface,
                         .box = box_of(boundary.faces[f].points),
                         .size = on[f],
                         .asked = true});
  return sources;
}

std::vector<std::string> sizes_of_nothing(const std::vector<SizeControl>& sizes,
                                          const BoundaryModel& boundary) {
  std::vector<std::string> ids;
  for (const SizeControl& control : sizes)
    if (const auto* selected = std::get_if<Selected>(&control.place))
      if (std::ranges::none_of(boundary.faces, [&](const BoundaryFace& face) {
            return std::isfinite(asked_on(face, *selected));
          }))
        ids.push_back(control.id);
  return ids;
}

}  // namespace remeshd
