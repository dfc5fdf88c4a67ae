#include "tests/campaign/parts/part_edit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "engine/base/error.h"
#include "engine/model/solid.h"
#include "tests/campaign/draft.h"
#include "tests/campaign/parts/drawing.h"

namespace remeshd::campaign {
namespace {

constexpr double kLargest = 0.2;  // share of the part's volume: what has more is its body

Vec3 axis_of(const Feature& feature) { return feature.placement.rotate({0, 0, 1}); }

std::string stem(const std::string& id) { return id.substr(0, id.find_first_of("0123456789")); }

/// A number of the part that can be set: given by how much it changes, 0 is as it is.
struct Handle {
  std::function<void(double, ModelEdit&)> set;  ///< adds the edits for an amount
  double size = 0;                              ///< length that an amount of 1 changes it by
  bool is_place = false;  ///< amounts are of the feature's size, not of a value
};

class Changer {
 public:
  Changer(const ModelSource& part, Random& random, int& serial)
      : part_(part),
        model_(evaluate(part)),
        patterns_(patterns(part)),
        random_(random),
        serial_(serial),
        diagonal_(Membership(model_).bounds().diagonal()) {
    for (const Feature& feature : model_.features) {
      const double volume = volume_of(feature.shape);
      volumes_.push_back(volume);
      if (feature.nature == Nature::Additive) material_ += volume;
    }
  }

  ChangeSteps operator()(Change change) {
    switch (change) {
      case Change::Drift:
        return drift();
      case Change::Sweep:
        return sweep();
      case Change::Jump:
        return jump();
      case Change::Move:
        return move();
      case Change::Addition:
        return addition();
      case Change::Removal:
        return removal();
    }
    return {};
  }

 private:
  double between(double lo, double hi) { return random_.uniform(lo, hi); }
  bool chance(double probability) { return random_.uniform() < probability; }
  double sign() { return chance(0.5) ? 1 : -1; }
  template <class T>
  const T& any(const std::vector<T>& values) {
    return values[random_.below(values.size())];
  }

  /// Every pattern is as likely, however many features it has.
  const std::vector<int>& any_pattern() { return any(patterns_); }
  /// One that is not of the body, or of all of them.
  const std::vector<int>& any_detail() {
    for (int k = 0; k < 20; ++k) {
      const std::vector<int>& pattern = any_pattern();
      if (volumes_[pattern.front()] < kLargest * material_) return pattern;
    }
    throw error::unknown_feature("any detail");
  }

  /// All of a pattern, or one of it, with what they carry.
  std::vector<int> any_details(double all) {
    const std::vector<int>& pattern = any_detail();
    const std::vector<int> some = chance(all) ? pattern : std::vector<int>{any(pattern)};
    std::vector<int> result;
    for (const int f : some)
      for (const int carried : with_what_it_carries(model_, f)) result.push_back(carried);
    std::ranges::sort(result);
    result.erase(std::ranges::unique(result).begin(), result.end());
    return result;
  }

  Vec3 any_direction(const Feature& feature) {
    const double angle = chance(0.5)
                             ? 0.5 * std::numbers::pi * static_cast<double>(random_.below(4))
                             : between(0, 2 * std::numbers::pi);
    return feature.placement.rotate({std::cos(angle), std::sin(angle), 0});
  }

  void shift(int f, const Vec3& by, ModelEdit& edit) const {
    const Vec3 at = Vec3{model_.features[f].placement.m[3], model_.features[f].placement.m[7],
                         model_.features[f].placement.m[11]} +
                    by;
    PlacementSource placement = part_.features[f].placement;
    placement.origin = {at.x, at.y, at.z};
    edit.edits.emplace_back(SetPlacement{part_.features[f].id, placement});
  }

  Handle place_handle() {
    const std::vector<int> details = any_details(0.3);
    const Feature& first = model_.features[details.front()];
    const double size = least_size(first);
    const Vec3 by = size * any_direction(first);
    return {[this, details, by](double amount, ModelEdit& edit) {
              for (const int f : details) shift(f, amount * by, edit);
            },
            size, true};
  }

  Handle model_handle() {
    const ParameterSource& p = any(part_.parameters);
    const double* value = std::get_if<double>(&p.value);
    if (value == nullptr) throw error::unknown_model_parameter(p.name);
    return {[name = p.name, v = *value](double amount, ModelEdit& edit) {
              edit.edits.emplace_back(SetParameter{name, v * (1 + amount)});
            },
            std::fabs(*value)};
  }

  /// The extent of an outline along one of its axes, about its middle.
  Handle profile_handle(const std::vector<int>& features) {
    const std::vector<ProfileEntry>& profile = *part_.features[features.front()].profile;
    Scalar ProfileEntry::*const axis = chance(0.5) ? &ProfileEntry::x : &ProfileEntry::y;
    double lo = HUGE_VAL, hi = -HUGE_VAL;
    for (const ProfileEntry& entry : profile) {
      const double* v = std::get_if<double>(&(entry.*axis));
      if (v == nullptr || entry.through) throw error::unknown_parameter("outline", "profile", "");
      lo = std::min(lo, *v);
      hi = std::max(hi, *v);
    }
    return {
        [this, features, profile, axis, middle = 0.5 * (lo + hi)](double amount, ModelEdit& edit) {
          std::vector<ProfileEntry> changed = profile;
          for (ProfileEntry& entry : changed) {
            const double v = std::get<double>(entry.*axis);
            entry.*axis = middle + (1 + amount) * (v - middle);
          }
          for (const int f : features)
            edit.edits.emplace_back(SetFeatureParameter{part_.features[f].id, "profile", changed});
        },
        0.5 * (hi - lo)};
  }

  Handle feature_handle() {
    const std::vector<int>& pattern = any_pattern();
    const std::vector<int> features = chance(0.7) ? pattern : std::vector<int>{any(pattern)};
    const FeatureSource& feature = part_.features[features.front()];
    std::vector<std::pair<std::string, double>> numbers;
    for (const auto& [name, value] : feature.parameters)
      if (const double* v = std::get_if<double>(&value); v != nullptr && name != "angle")
        numbers.emplace_back(name, *v);
    const std::size_t profiles = feature.profile ? 2 : 0;
    if (numbers.size() + profiles == 0) throw error::unknown_parameter(feature.id, "any", "");
    const std::size_t n = random_.below(numbers.size() + profiles);
    if (n >= numbers.size()) return profile_handle(features);
    return {[this, features, number = numbers[n]](double amount, ModelEdit& edit) {
              for (const int f : features)
                edit.edits.emplace_back(SetFeatureParameter{part_.features[f].id, number.first,
                                                            Scalar(number.second * (1 + amount))});
            },
            std::fabs(numbers[n].second)};
  }

  Handle any_handle() {
    const double kind = random_.uniform();
    if (kind < 0.25) return place_handle();
    if (kind < 0.5 && !part_.parameters.empty()) return model_handle();
    return feature_handle();
  }

  ChangeSteps drift() {
    struct Drifting {
      Handle handle;
      double rate;
    };
    std::vector<Drifting> all;
    for (std::uint64_t n = 1 + random_.below(2); n > 0; --n) {
      Handle handle = any_handle();
      const double rate = sign() * (handle.is_place ? between(0.01, 0.1) : between(0.003, 0.03));
      all.push_back({std::move(handle), rate});
    }
    ChangeSteps result;
    const std::uint64_t steps = 3 + random_.below(3);
    for (std::uint64_t k = 1; k <= steps; ++k) {
      double most = 0;
      ModelEdit& edit = result.edits.emplace_back();
      for (const auto& [handle, rate] : all) {
        handle.set(static_cast<double>(k) * rate, edit);
        most = std::max(most, std::fabs(rate) * handle.size);
      }
      result.sizes.push_back(most / diagonal_);
    }
    return result;
  }

  ChangeSteps sweep() {
    const Handle handle = any_handle();
    const double to = handle.is_place ? sign() * between(0.5, 2)
                      : chance(0.5)   ? between(0.3, 0.8)
                                      : -between(0.2, 0.45);
    const std::uint64_t steps = 4 + random_.below(3);
    ChangeSteps result;
    for (std::uint64_t k = 1; k <= steps; ++k) {
      handle.set(to * static_cast<double>(k) / static_cast<double>(steps),
                 result.edits.emplace_back());
      result.sizes.push_back(std::fabs(to) * handle.size / static_cast<double>(steps) / diagonal_);
    }
    return result;
  }

  ChangeSteps jump() {
    const Handle handle = any_handle();
    const double to = handle.is_place ? sign() * between(1, 4)
                      : chance(0.5)   ? between(0.4, 1.5)
                                      : -between(0.3, 0.6);
    ChangeSteps result;
    handle.set(to, result.edits.emplace_back());
    result.sizes.push_back(std::fabs(to) * handle.size / diagonal_);
    return result;
  }

  /// As far as to another place of the part.
  Vec3 far_away(const Feature& feature) {
    const double own = world_bounds(feature).diagonal();
    const double far = std::min(0.5 * diagonal_, own * between(0.5, 4));
    return far * any_direction(feature);
  }

  ChangeSteps move() {
    const std::vector<int> details = any_details(0.3);
    const Vec3 by = far_away(model_.features[details.front()]);
    ChangeSteps result;
    ModelEdit& edit = result.edits.emplace_back();
    for (const int f : details) shift(f, by, edit);
    result.sizes.push_back(norm(by) / diagonal_);
    return result;
  }

  /// Another one elsewhere, of the same measurements or a little larger or smaller ones.
  ChangeSteps addition() {
    const std::vector<int> details = any_details(0.3);
    const Vec3 by = far_away(model_.features[details.front()]);
    const double scale = chance(0.5) ? 1 : between(0.75, 1.25);
    ChangeSteps result;
    ModelEdit& edit = result.edits.emplace_back();
    const std::string prefix = "a" + std::to_string(++serial_) + "_";
    for (const int f : details) {
      FeatureSource feature = part_.features[f];
      feature.id = prefix + std::to_string(f);
      for (auto& [name, value] : feature.parameters)
        if (double* v = std::get_if<double>(&value); v != nullptr && is_across(name)) *v *= scale;
      const Transform& at = model_.features[f].placement;
      feature.placement.origin = {at.m[3] + by.x, at.m[7] + by.y, at.m[11] + by.z};
      edit.edits.emplace_back(AddFeature{feature, ""});
    }
    result.sizes.push_back(least_size(model_.features[details.front()]) / diagonal_);
    return result;
  }
  static bool is_across(const std::string& name) {
    return name == "width" || name.find("radius") != std::string::npos;
  }

  ChangeSteps removal() {
    const std::vector<int> details = any_details(0.4);
    ChangeSteps result;
    ModelEdit& edit = result.edits.emplace_back();
    for (const int f : details) edit.edits.emplace_back(RemoveFeature{part_.features[f].id});
    result.sizes.push_back(least_size(model_.features[details.front()]) / diagonal_);
    return result;
  }

  const ModelSource& part_;
  const FeatureModel model_;
  const std::vector<std::vector<int>> patterns_;
  Random& random_;
  int& serial_;
  const double diagonal_;
  std::vector<double> volumes_;  ///< of features
  double material_ = 0;          ///< volume of all additive features
};

}  // namespace

std::vector<std::vector<int>> patterns(const ModelSource& part) {
  std::vector<std::vector<int>> result;
  for (int k = 0; k < static_cast<int>(part.features.size()); ++k) {
    const FeatureSource& feature = part.features[k];
    const auto same = std::ranges::find_if(result, [&](const std::vector<int>& pattern) {
      const FeatureSource& first = part.features[pattern.front()];
      return first.type == feature.type && first.nature == feature.nature &&
             first.parameters == feature.parameters && first.profile == feature.profile &&
             stem(first.id) == stem(feature.id);
    });
    if (same == result.end())
      result.push_back({k});
    else
      same->push_back(k);
  }
  return result;
}

std::vector<int> with_what_it_carries(const FeatureModel& model, int feature) {
  constexpr double kSame = 1e-6;  // of its size
  const Feature& carrier = model.features[feature];
  const Vec3 axis = axis_of(carrier);
  const Vec3 origin = carrier.placement.apply({});
  const Box box = world_bounds(carrier);
  const auto width = [](const Feature& f) {
    const Box local = local_bounds(f.shape);
    return std::max(local.hi.x - local.lo.x, local.hi.y - local.lo.y);
  };
  std::vector<int> result;
  for (int k = 0; k < static_cast<int>(model.features.size()); ++k) {
    const Feature& other = model.features[k];
    const double off = norm(cross(other.placement.apply({}) - origin, axis));
    const bool carried = k > feature && norm(cross(axis, axis_of(other))) < kSame &&
                         off < kSame * box.diagonal() && width(other) < width(carrier) &&
                         touch(box, world_bounds(other));
    if (k == feature || carried) result.push_back(k);
  }
  return result;
}

ChangeSteps random_change(const ModelSource& part, Change change, Random& random, int& serial) {
  return Changer(part, random, serial)(change);
}

}  // namespace remeshd::campaign
