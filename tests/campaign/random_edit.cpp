#include "tests/campaign/random_edit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/base/error.h"
#include "engine/model/feature_model.h"
#include "engine/model/solid.h"
#include "tests/campaign/mean_features.h"
#include "tests/campaign/site_features.h"

namespace remeshd::campaign {
namespace {

constexpr std::size_t kMostFeatures = 40;
constexpr std::size_t kFewestFeatures = 3;

/// The evaluated model and its size.
struct Now {
  FeatureModel model;
  double diagonal;
};

Now evaluate_now(const Draft& d) {
  Now now{evaluate(d.model), 0};
  now.diagonal = Membership(now.model).bounds().diagonal();
  return now;
}

bool is_body(const Draft& d, const std::string& id) {
  return std::find(d.body.begin(), d.body.end(), id) != d.body.end();
}

/// A number changed by some of itself: half of the time by 1e-9 to all of it.
double changed(Draft& d, double v) {
  if (d.chance(0.45)) return v * (1 + (d.chance(0.5) ? 1 : -1) * d.log_uniform(1e-9, 0.9));
  return v * d.random.uniform(0.6, 1.5);
}

RandomEdit set_parameter(Draft& d, const Now& now) {
  std::vector<std::pair<std::string, double>> numbers;
  for (const ParameterSource& p : d.model.parameters)
    if (const double* v = std::get_if<double>(&p.value)) numbers.emplace_back(p.name, *v);
  if (numbers.empty()) throw error::unknown_model_parameter("any");
  const auto& [name, v] = numbers[d.random.below(numbers.size())];
  const double to = v == 0 ? d.length * d.log_uniform(1e-9, 1) : changed(d, v);
  return {{{SetParameter{name, to}}}, "", std::fabs(to - v) / now.diagonal};
}

/// One entry of the outline moved, or all of it scaled.
std::vector<ProfileEntry> changed(Draft& d, std::vector<ProfileEntry> profile, double& size) {
  const auto scale = [&](Scalar& s, double by) {
    if (double* v = std::get_if<double>(&s)) {
      size = std::max(size, std::fabs(*v * by - *v));
      *v *= by;
    }
  };
  if (d.chance(0.5)) {
    const double by = changed(d, 1);
    for (ProfileEntry& entry : profile) {
      scale(entry.x, by);
      scale(entry.y, by);
      if (!entry.through) continue;
      scale((*entry.through)[0], by);
      scale((*entry.through)[1], by);
    }
    return profile;
  }
  ProfileEntry& entry = profile[d.random.below(profile.size())];
  const double by = changed(d, 1);
  scale(d.chance(0.5) ? entry.x : entry.y, by);
  return profile;
}

RandomEdit set_feature_parameter(Draft& d, const Now& now) {
  const FeatureSource& f = d.model.features[d.random.below(d.model.features.size())];
  if (f.profile && d.chance(0.6)) {
    double size = 0;
    std::vector<ProfileEntry> profile = changed(d, *f.profile, size);
    return {{{SetFeatureParameter{f.id, "profile", std::move(profile)}}}, "", size / now.diagonal};
  }
  if (f.parameters.empty()) throw error::unknown_parameter(f.id, "any", "");
  auto at = f.parameters.begin();
  std::advance(at, static_cast<std::ptrdiff_t>(d.random.below(f.parameters.size())));
  // An expression by itself times a number.
  const double* number = std::get_if<double>(&at->second);
  if (number == nullptr) {
    const double by = changed(d, 1);
    const std::string text = "(" + std::get<std::string>(at->second) + ")*" + text_of_number(by);
    if (text.size() > 200) throw error::unknown_parameter(f.id, at->first, "");
    return {{{SetFeatureParameter{f.id, at->first, Scalar(text)}}},
            "",
            std::fabs(by - 1) * d.length / now.diagonal};
  }
  double to = *number == 0 ? d.length : changed(d, *number);
  if (at->first == "angle") to = std::min(to, 360.0);
  return {{{SetFeatureParameter{f.id, at->first, Scalar(to)}}},
          "",
          std::fabs(to - *number) / now.diagonal};
}

std::vector<std::size_t> taken_sites(const Draft& d) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < d.sites.size(); ++k)
    if (!d.sites[k].features.empty()) result.push_back(k);
  return result;
}

/// The same edit for each feature: `motion` from the left.
RandomEdit move(const Draft& d, const Now& now, const std::vector<std::string>& ids,
                const Transform& motion) {
  RandomEdit result{{}, "", 0};
  for (const std::string& id : ids) {
    const int index = now.model.index_of(id);
    if (index < 0) continue;
    const Transform from = now.model.features[index].placement, to = motion * from;
    result.edit.edits.emplace_back(SetPlacement{id, placement_of(to)});
    double by = 0;
    for (const double corner : {0.0, d.length})
      by = std::max(by, distance(from.apply({corner, 0, 0}), to.apply({corner, 0, 0})));
    result.size = std::max(result.size, by / now.diagonal);
  }
  if (result.edit.edits.empty()) throw error::unknown_feature("any");
  return result;
}

RandomEdit set_placement(Draft& d, const Now& now, bool gentle) {
  const std::vector<std::size_t> taken = taken_sites(d), open = free_sites(d);
  if (!taken.empty() && (gentle || d.chance(0.4))) {
    Site& site = d.sites[taken[d.random.below(taken.size())]];
    if (!open.empty() && d.chance(0.35)) {
      Site& other = d.sites[open[d.random.below(open.size())]];
      if (other.radius >= 0.8 * site.radius) {
        const RandomEdit result =
            move(d, now, site.features, other.frame * rigid_inverse(site.frame));
        std::swap(site.features, other.features);
        return result;
      }
    }
    const double far = d.length * d.log_uniform(1e-9 * now.diagonal / d.length, 3);
    const double way = d.random.uniform(0, 2 * std::numbers::pi);
    const double spin = d.chance(0.3) ? d.log_uniform(1e-9, 1) : 0;
    const Transform to =
        turned(shifted(site.frame, far * std::cos(way), far * std::sin(way), 0), 2, spin);
    return move(d, now, site.features, to * rigid_inverse(site.frame));
  }
  const Feature& feature = now.model.features[d.random.below(now.model.features.size())];
  const double far = now.diagonal * d.log_uniform(1e-9, 1);
  Transform motion = shifted(feature.placement, 0, 0, 0);
  const Vec3 way = random_rotation(d.random).rotate({far, 0, 0});
  if (d.chance(0.5))
    motion =
        shifted(motion, d.chance(0.5) ? far : 0, d.chance(0.3) ? far : 0, d.chance(0.5) ? far : 0);
  else
    motion = shifted(motion, way.x, way.y, way.z);
  if (d.chance(0.4))
    motion = turned(motion, static_cast<int>(d.random.below(3)), d.log_uniform(1e-9, 3));
  return move(d, now, {feature.id}, motion * rigid_inverse(feature.placement));
}

RandomEdit add_feature(Draft& d, const Now& now, bool gentle) {
  if (d.model.features.size() >= kMostFeatures) throw error::no_features();
  const std::size_t before = d.model.features.size();
  d.may_add_parameters = false;
  const std::vector<std::size_t> open = free_sites(d);
  if (gentle || (!open.empty() && d.chance(0.2))) {
    if (open.empty()) throw error::no_features();
    add_on_site(d, open[d.random.below(open.size())]);
  } else {
    if (d.sites.empty()) throw error::no_features();
    const auto add = [&](Trouble family) {
      add_trouble(d, family, d.sites[d.random.below(d.sites.size())]);
    };
    // Those that the campaign promises, or anything.
    if (d.chance(0.4)) add(Trouble::Tangent);
    if (d.chance(0.4)) add(Trouble::Wedge);
    if (d.model.features.size() == before || d.chance(0.3))
      add(static_cast<Trouble>(d.random.below(kTroubles)));
  }
  RandomEdit result{{}, "", 0};
  std::string after;
  if (!gentle && before > 1 && d.chance(0.2)) after = d.model.features[d.random.below(before)].id;
  for (std::size_t k = before; k < d.model.features.size(); ++k) {
    result.edit.edits.emplace_back(AddFeature{d.model.features[k], after});
    if (!after.empty()) after = d.model.features[k].id;
  }
  if (result.edit.edits.empty()) throw error::no_features();
  const FeatureModel with = evaluate(d.model);
  for (std::size_t k = before; k < with.features.size(); ++k)
    result.size = std::max(result.size, world_bounds(with.features[k]).diagonal() / now.diagonal);
  d.model.features.resize(before);
  return result;
}

RandomEdit remove_feature(Draft& d, const Now& now, bool gentle) {
  std::vector<std::string> ids;
  const std::vector<std::size_t> taken = taken_sites(d);
  if (!taken.empty() && (gentle || d.chance(0.3))) {
    std::swap(ids, d.sites[taken[d.random.below(taken.size())]].features);
  } else {
    const std::string& id = d.model.features[d.random.below(d.model.features.size())].id;
    if (!is_body(d, id) || (!gentle && d.chance(0.3))) ids = {id};
  }
  std::erase_if(ids, [&](const std::string& id) { return now.model.index_of(id) < 0; });
  if (ids.empty() || d.model.features.size() < kFewestFeatures + ids.size())
    throw error::no_features();
  RandomEdit result{{}, "", 0};
  for (const std::string& id : ids) {
    result.edit.edits.emplace_back(RemoveFeature{id});
    for (Site& site : d.sites) std::erase(site.features, id);
    result.size =
        std::max(result.size, world_bounds(now.model.features[now.model.index_of(id)]).diagonal() /
                                  now.diagonal);
  }
  return result;
}

}  // namespace

RandomEdit random_edit(Draft& d, std::size_t kind, bool gentle) {
  const Now now = evaluate_now(d);
  RandomEdit result;
  switch (kind) {
    case 0:
      result = set_parameter(d, now);
      break;
    case 1:
      result = set_feature_parameter(d, now);
      break;
    case 2:
      result = set_placement(d, now, gentle);
      break;
    case kAddFeature:
      result = add_feature(d, now, gentle);
      break;
    default:
      result = remove_feature(d, now, gentle);
  }
  result.kind = kEditKinds[kind];
  d.model = apply(d.model, result.edit);
  return result;
}

}  // namespace remeshd::campaign
