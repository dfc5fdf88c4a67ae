#include "tests/campaign/draft.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/cellular/cellular_model.h"
#include "engine/model/feature_model.h"
#include "engine/nodes/density.h"
#include "tests/support/cases.h"

namespace remeshd::campaign {
namespace {

Vec3 column(const Transform& t, int k) { return {t.m[k], t.m[4 + k], t.m[8 + k]}; }

FeatureSource& append(Draft& draft, const std::string& type, Nature nature,
                      const Transform& placement,
                      const std::vector<std::pair<std::string, double>>& parameters) {
  FeatureSource feature;
  feature.id = type + std::to_string(++draft.serial);
  feature.type = type;
  feature.nature = nature;
  feature.placement = placement_of(placement);
  for (const auto& [name, v] : parameters) feature.parameters[name] = draft.value(v);
  if (draft.chance(0.25)) feature.reference = ReferenceKind::Centre;
  return draft.model.features.emplace_back(std::move(feature));
}

}  // namespace

std::string text_of_number(double v) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.17g", v);
  return buffer.data();
}

double Draft::log_uniform(double lo, double hi) {
  return std::exp(random.uniform(std::log(lo), std::log(hi)));
}

Scalar Draft::value(double v) {
  if (!chance(0.4)) return v;
  std::vector<std::pair<std::string, double>> numbers;
  for (const ParameterSource& p : model.parameters)
    if (const double* number = std::get_if<double>(&p.value)) numbers.emplace_back(p.name, *number);
  if (may_add_parameters && (numbers.empty() || (numbers.size() < 8 && chance(0.4)))) {
    std::string name = "p" + std::to_string(model.parameters.size() + 1);
    model.parameters.push_back({name, v});
    return name;
  }
  if (numbers.empty()) return v;
  const auto& [name, base] = numbers[random.below(numbers.size())];
  if (base > 0 && v > 0 && chance(0.5)) return name + "*" + text_of_number(v / base);
  return name + (v < base ? "-" : "+") + text_of_number(std::fabs(v - base));
}

std::string Draft::add(const std::string& type, Nature nature, const Transform& placement,
                       const std::vector<std::pair<std::string, double>>& parameters) {
  return append(*this, type, nature, placement, parameters).id;
}

std::string Draft::add_outline(const std::string& type, Nature nature, const Transform& placement,
                               const std::vector<ProfileEntry>& profile,
                               const std::vector<std::pair<std::string, double>>& parameters) {
  FeatureSource& feature = append(*this, type, nature, placement, parameters);
  feature.profile = profile;
  return feature.id;
}

PlacementSource placement_of(const Transform& frame) {
  PlacementSource placement;
  placement.origin = {frame.m[3], frame.m[7], frame.m[11]};
  const Vec3 x = column(frame, 0), z = column(frame, 2);
  if (z != Vec3{0, 0, 1}) placement.z_axis = std::array<Scalar, 3>{z.x, z.y, z.z};
  if (placement.z_axis || x != Vec3{1, 0, 0})
    placement.x_axis = std::array<Scalar, 3>{x.x, x.y, x.z};
  return placement;
}

Transform shifted(const Transform& frame, double x, double y, double z) {
  return frame * Transform::translation({x, y, z});
}

Transform turned(const Transform& frame, int axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  if (axis == 0) return frame * Transform::frame({1, 0, 0}, {0, c, s}, {0, -s, c}, {});
  if (axis == 1) return frame * Transform::frame({c, 0, -s}, {0, 1, 0}, {s, 0, c}, {});
  return frame * Transform::frame({c, s, 0}, {-s, c, 0}, {0, 0, 1}, {});
}

Transform random_rotation(Random& random) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const Transform spin = turned({}, 2, random.uniform(0, kTurn));
  const Transform tilt = turned(spin, 1, std::acos(random.uniform(-1, 1)));
  return turned(tilt, 2, random.uniform(0, kTurn));
}

std::vector<ProfileEntry> polygon(int corners, double radius) {
  std::vector<ProfileEntry> result;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    result.push_back(test::point(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return result;
}

std::vector<ProfileEntry> outline(const std::vector<std::array<double, 2>>& corners) {
  std::vector<ProfileEntry> result;
  for (const auto& [x, y] : corners) result.push_back(test::point(x, y));
  return result;
}

void find_length(Draft& draft) {
  const CellularModel cells = build_cells(evaluate(draft.model), Run{});
  draft.length = edge_length_for(cells.volume, cells.area, draft.nodes);
}

}  // namespace remeshd::campaign
