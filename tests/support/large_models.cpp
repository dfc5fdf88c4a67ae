#include "tests/support/large_models.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/support/cases.h"

namespace remeshd::test {
namespace {

FeatureSource& find(ModelSource& model, const std::string& id) {
  const auto it = std::ranges::find(model.features, id, &FeatureSource::id);
  if (it == model.features.end()) throw std::invalid_argument("no feature " + id);
  return *it;
}

FeatureSource slot(std::string id, double length, double width, double height) {
  return feature(std::move(id), "slot", {{"length", length}, {"width", width}, {"height", height}});
}

}  // namespace

ModelSource plate_with_grid(int features) {
  const int side = static_cast<int>(std::ceil(std::sqrt(features - 1)));
  const double width = 20.0 * side;
  std::vector<FeatureSource> all{block("plate", width, width, 10)};
  for (int k = 1; k < features; ++k) {
    const double x = 20.0 * ((k - 1) % side) + 10 - width / 2;
    const double y = 20.0 * ((k - 1) / side) + 10 - width / 2;
    const std::string id = "f" + std::to_string(k);
    if (k % 2 == 0)
      all.push_back(placed(cylinder(id, 5, 12), x, y, 10));
    else
      all.push_back(placed(cylinder(id, 6, 10), x, y, 0, Nature::Subtractive));
  }
  return model_of(std::move(all));
}

ModelSource row_of_blocks(int features) {
  std::vector<FeatureSource> all;
  for (int k = 0; k < features; ++k)
    all.push_back(placed(block("f" + std::to_string(k), 12, 10 + k % 3, 8 + k % 2), 10.0 * k,
                         0.5 * (k % 5), 0.25 * (k % 4)));
  return model_of(std::move(all));
}

ModelSource mixed_model(int features) {
  // A plate with six places, two features each, and two slots: 15 features.
  std::vector<FeatureSource> all;
  for (int p = 0; static_cast<int>(all.size()) < features; ++p) {
    const double x = 100.0 * (p % 6), y = 90.0 * (p / 6);
    const std::string plate = "p" + std::to_string(p);
    const double thick = 8 + p % 3;
    all.push_back(placed(block(plate, 110, 100, thick), x, y, 0));
    for (int k = 0; k < 6; ++k) {
      const double bx = x + 30.0 * (k % 3 - 1), by = y + (k < 3 ? -22 : 22);
      all.push_back(placed(cylinder(plate + "boss" + std::to_string(k), 9, 25), bx, by, 0));
      all.push_back(placed(cylinder(plate + "hole" + std::to_string(k), 5, 25), bx, by, 0,
                           Nature::Subtractive));
    }
    for (int k = 0; k < 2; ++k)
      all.push_back(placed(slot(plate + "slot" + std::to_string(k), 24, 7, 20),
                           x + (k == 0 ? -15 : 15), y, 0, Nature::Subtractive));
  }
  all.resize(features);
  return model_of(std::move(all));
}

ModelSource with_moved(ModelSource model, const std::string& id, double x, double y, double z) {
  auto& origin = find(model, id).placement.origin;
  const std::array<double, 3> by{x, y, z};
  for (int i = 0; i < 3; ++i) origin[i] = std::get<double>(origin[i]) + by[i];
  return model;
}

ModelSource with_parameter(ModelSource model, const std::string& id, const std::string& name,
                           double value) {
  find(model, id).parameters.at(name) = value;
  return model;
}

}  // namespace remeshd::test
