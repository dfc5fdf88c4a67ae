#include "engine/sizing/size_controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include "engine/base/error.h"
#include "engine/cellular/boundary_model/face_part.h"
#include "engine/model/selection/selected_material.h"
#include "engine/model/solid.h"
#include "engine/sizing/reserve.h"

namespace remeshd {

namespace {

using Selected = std::vector<SizedFaces>;

struct SelectionLimits {
  double part_length = 0.5;         ///< of the length asked for: triangles at the border of a part
  double material_balls = 50000;    ///< in the boxes of all features named, about
  std::size_t triangles = 500'000;  ///< of all parts of faces
  double aside = 1e-6;              ///< x diagonal: points beside a face, to tell whose it is
  double rectangle = 1e-9;          ///< by how much rounding may change a rectangle's sides
};
constexpr SelectionLimits kSelectionLimits;

/// The selected feature faces that cover some part of a face of the boundary.
std::vector<const SizedFaces*> selected_on(const BoundaryFace& face, const Selected& selected) {
  std::vector<const SizedFaces*> found;
  for (const FaceName& name : face.names) {
    const auto of_feature = std::ranges::equal_range(
        selected, name.feature, {}, [](const SizedFaces& sized) { return sized.on.feature; });
    for (const SizedFaces& sized : of_feature)
      if (std::ranges::find(sized.on.faces, name.face) != sized.on.faces.end() &&
          std::ranges::find(found, &sized) == found.end())
        found.push_back(&sized);
  }
  return found;
}

bool is_conditional(const SizedFaces& sized) { return !sized.on.condition.text.empty(); }

/// Whether a length is asked for on all of a face of the boundary: no condition leaves a part of it
/// out, and faces of other features that are flush with it have that length or less by `selected`,
/// which are all of a control's that name the face.
bool is_on_all_of(const BoundaryFace& face, const SizedFaces& sized,
                  const std::vector<const SizedFaces*>& selected) {
  const auto has_it = [&](const FaceName& name) {
    return std::ranges::any_of(selected, [&](const SizedFaces* other) {
      return other->on.feature == name.feature && !is_conditional(*other) &&
             other->size <= sized.size;
    });
  };
  return !is_conditional(sized) && std::ranges::all_of(face.names, has_it);
}

/// The parts of a face of the boundary that are of a feature's own face, where the condition holds,
/// as fine as the length asked for.
std::vector<std::array<Vec3, 3>> part_of(const BoundaryFace& face, const SizedFaces& sized,
                                         const Membership& membership, const Run& run) {
  const double length = kSelectionLimits.part_length * sized.size;
  const Solid& solid = membership.solids()[sized.on.feature];
  if (std::ranges::all_of(face.names,
                          [&](const FaceName& name) { return name.feature == sized.on.feature; }))
    return part_where(face, sized.on.condition, length, run);
  const double aside = kSelectionLimits.aside * membership.bounds().diagonal();
  std::optional<ConditionTest> holds;
  if (is_conditional(sized)) holds.emplace(sized.on.condition);
  const auto is_own = [&](const Vec3& at, const Vec3& n) {
    const Vec3 p = project(face.surface, at);
    return solid.contains(p + aside * n) != solid.contains(p - aside * n) &&
           (!holds || (*holds)(p, n));
  };
  const Box box = intersection(box_of(face.points), grown(solid.bounds(), aside));
  return part_within(box, face, is_own, length, run);
}

/// Whether a plane face is a rectangle with sides along the axes, and fills its box.
bool fills_box(const BoundaryFace& face) {
  const Vec3 extent = box_of(face.points).hi - box_of(face.points).lo;
  std::array<double, 3> sides{extent.x, extent.y, extent.z};
  std::ranges::sort(sides);
  return sides[0] <= kSelectionLimits.rectangle * sides[2] &&
         face.area >= (1 - kSelectionLimits.rectangle) * sides[1] * sides[2];
}

/// What all of a face asks for. A plane one that does not fill its box is given by its triangles:
/// its plane goes on in the material under what stands on it.
void add_face(const BoundaryFace& face, double size, std::vector<SizeSource>& sources) {
  SizeSource source{.piece = face.surface,
                    .box = box_of(face.points),
                    .size = size / kReserveOnFaces,
                    .asked = true,
                    .wanted = size};
  if (face.surface.kind != Surface::Kind::Plane || fills_box(face)) {
    sources.push_back(source);
    return;
  }
  for (const auto& [a, b, c] : face.triangles) {
    const std::array<Vec3, 3> triangle{face.points[a], face.points[b], face.points[c]};
    source.piece = triangle;
    source.box = box_of(triangle);
    sources.push_back(source);
  }
}

/// Covers the material of features that size controls name with balls of the length asked for.
class MaterialCover {
 public:
  MaterialCover(const FeatureModel& model, const Membership& membership, const Run& run)
      : model_(model), run_(run), membership_(membership) {
    for (const SizeControl& control : model.sizes)
      if (const auto* selected = std::get_if<Selected>(&control.place))
        features_ += std::ranges::count_if(*selected, [&](const auto& s) { return has_any(s); });
  }

  /// Balls round the points of a cubic lattice in the feature's material where the condition holds.
  /// The lattice constant is the length asked for, or more where that would be too many points;
  /// across a thinner feature it is the thickness. None where the selector does not name the
  /// material.
  [[nodiscard]] std::vector<SizedBall> of(const SizedFaces& sized) const {
    if (!has_any(sized)) return {};
    const Box& box = membership_.solids()[sized.on.feature].bounds();
    const Vec3 extent = box.hi - box.lo;
    const double most =
        std::fmax(1, kSelectionLimits.material_balls / static_cast<double>(features_));
    double apart = std::fmax(sized.size, std::cbrt(extent.x * extent.y * extent.z / most));
    const auto across = [&](double v) { return std::ceil(v / apart); };
    while (across(extent.x) * across(extent.y) * across(extent.z) > 2 * most) apart *= 1.5;  // thin
    const auto steps = [&](double v) { return static_cast<int>(across(v)); };
    const Vec3 step{std::fmin(apart, extent.x), std::fmin(apart, extent.y),
                    std::fmin(apart, extent.z)};
    std::optional<ConditionTest> holds;
    if (is_conditional(sized)) holds.emplace(sized.on.condition);
    Polling poll(run_);
    std::vector<SizedBall> balls;
    for (int k = 0; k < steps(extent.z); ++k)
      for (int j = 0; j < steps(extent.y); ++j)
        for (int i = 0; i < steps(extent.x); ++i) {
          poll();
          const Vec3 p = box.lo + Vec3{(i + 0.5) * step.x, (j + 0.5) * step.y, (k + 0.5) * step.z};
          if (membership_.contains(sized.on.feature, p) && membership_.inside(p) &&
              (!holds || (*holds)(p, {})))
            balls.push_back({p, 0.5 * std::numbers::sqrt3 * apart, sized.size});
        }
    return balls;
  }

 private:
  [[nodiscard]] bool has_any(const SizedFaces& sized) const {
    return sized.on.whole && model_.features[sized.on.feature].nature == Nature::Additive;
  }

  const FeatureModel& model_;
  const Run& run_;
  const Membership& membership_;
  std::ptrdiff_t features_ = 0;  ///< whose material is named
};

/// The plane of its top, filled below: that is all of the box.
SizeSource source_of(const SizedBox& box) {
  return {.piece = Surface{Surface::Kind::Plane, Transform::translation(box.hi), 0, 0},
          .box = {box.lo, box.hi},
          .size = box.size / kReserveInside,
          .asked = true,
          .filled = true,
          .wanted = box.size};
}

SizeSource source_of(const SizedBall& ball) {
  SizeSource source = size_source(ball);
  source.wanted = ball.size;
  source.size = ball.size / kReserveInside;
  return source;
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

std::vector<SizeSource> size_sources(const FeatureModel& model, const BoundaryModel& boundary,
                                     const Run& run) {
  std::vector<double> on(boundary.faces.size(), HUGE_VAL);  // whole faces
  std::vector<SizeSource> sources;
  if (model.sizes.empty()) return sources;
  std::size_t triangles = 0;
  const Membership membership(model);
  const MaterialCover material(model, membership, run);
  for (const SizeControl& control : model.sizes) {
    if (const auto* selected = std::get_if<Selected>(&control.place)) {
      for (const SizedFaces& sized : *selected)
        for (const SizedBall& ball : material.of(sized)) sources.push_back(source_of(ball));
      for (std::size_t f = 0; f < on.size(); ++f) {
        const auto named = selected_on(boundary.faces[f], *selected);
        for (const SizedFaces* sized : named) {
          if (is_on_all_of(boundary.faces[f], *sized, named)) {
            on[f] = std::fmin(on[f], sized->size);
            continue;
          }
          const auto part = part_of(boundary.faces[f], *sized, membership, run);
          triangles += part.size();
          if (triangles > kSelectionLimits.triangles)
            throw error::limit_exceeded("", "sizes." + control.id + ".on",
                                        "triangles that the parts of faces are divided into,",
                                        triangles, kSelectionLimits.triangles);
          for (const auto& triangle : part)
            sources.push_back({.piece = triangle,
                               .box = box_of(triangle),
                               .size = sized->size / kReserveOnFaces,
                               .asked = true,
                               .wanted = sized->size});
        }
      }
    } else if (const auto* ball = std::get_if<SizedBall>(&control.place)) {
      sources.push_back(source_of(*ball));
    } else {
      sources.push_back(source_of(std::get<SizedBox>(control.place)));
    }
  }
  for (std::size_t f = 0; f < on.size(); ++f)
    if (std::isfinite(on[f])) add_face(boundary.faces[f], on[f], sources);
  return sources;
}

std::vector<std::string> sizes_outside(const FeatureModel& model, const Box& bounds) {
  std::vector<std::string> ids;
  for (const SizeControl& control : model.sizes) {
    if (std::holds_alternative<Selected>(control.place)) continue;
    const auto* ball = std::get_if<SizedBall>(&control.place);
    const SizeSource source =
        ball != nullptr ? size_source(*ball) : source_of(std::get<SizedBox>(control.place));
    if (intersection(source.box, bounds).empty()) ids.push_back(control.id);
  }
  return ids;
}

std::vector<std::string> sizes_of_nothing(const FeatureModel& model, const BoundaryModel& boundary,
                                          const Run& run) {
  std::vector<std::string> ids;
  if (model.sizes.empty()) return ids;
  const Membership membership(model);
  for (const SizeControl& control : model.sizes) {
    const auto* selected = std::get_if<Selected>(&control.place);
    if (selected == nullptr) continue;
    const auto names = [&](const BoundaryFace& face) {
      return std::ranges::any_of(selected_on(face, *selected), [&](const SizedFaces* sized) {
        return !is_conditional(*sized) || !part_of(face, *sized, membership, run).empty();
      });
    };
    const auto finds_material = [&](const SizedFaces& sized) {
      return has_material(sized.on, model, membership, run);
    };
    if (std::ranges::none_of(boundary.faces, names) &&
        std::ranges::none_of(*selected, finds_material))
      ids.push_back(control.id);
  }
  return ids;
}

}  // namespace remeshd
