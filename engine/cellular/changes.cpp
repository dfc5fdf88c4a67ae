#include "engine/cellular/changes.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

namespace remeshd {
namespace {

// x the diagonal: far more than the CAD kernel's tolerance, and no round number, so that sides of
// the boxes do not coincide with faces of features that did not change.
constexpr double kMargin = 3.7e-6;

bool same(const Feature& a, const Feature& b) {
  return a.nature == b.nature && a.placement == b.placement && a.shape == b.shape;
}

/// Leaves the longest ascending subsequence of the numbers that are not -1; the others become -1.
void keep_ascending(std::vector<int>& numbers) {
  std::vector<int> ends;  // by length - 1: where the subsequence with the lowest last number ends
  std::vector<int> before(numbers.size(), -1);
  for (int i = 0; i < static_cast<int>(numbers.size()); ++i) {
    if (numbers[i] < 0) continue;
    const auto at =
        std::ranges::lower_bound(ends, numbers[i], {}, [&](int end) { return numbers[end]; });
    before[i] = at == ends.begin() ? -1 : *(at - 1);
    if (at == ends.end())
      ends.push_back(i);
    else
      *at = i;
  }
  std::vector<int> kept(numbers.size(), -1);
  for (int i = ends.empty() ? -1 : ends.back(); i >= 0; i = before[i]) kept[i] = numbers[i];
  numbers = std::move(kept);
}

}  // namespace

bool touch(const std::vector<Box>& boxes, const Box& b) {
  return std::ranges::any_of(boxes, [&](const Box& a) { return touch(a, b); });
}

Changes find_changes(const FeatureModel& base, const FeatureModel& model,
                     const Membership& membership) {
  Changes out;
  std::unordered_map<std::string_view, int> index;
  for (int f = 0; f < static_cast<int>(model.features.size()); ++f)
    index.emplace(model.features[f].id, f);
  for (const Feature& feature : base.features) {
    const auto it = index.find(feature.id);
    const bool kept = it != index.end() && same(feature, model.features[it->second]);
    out.kept.push_back(kept ? it->second : -1);
  }
  keep_ascending(out.kept);
  const double margin = kMargin * membership.bounds_of_all().diagonal();
  const auto add = [&](const Feature& feature) {
    for (const Box& box : boxes_round(feature)) out.boxes.push_back(grown(box, margin));
  };
  std::vector<char> kept(model.features.size(), 0);
  for (std::size_t f = 0; f < base.features.size(); ++f) {
    if (out.kept[f] >= 0)
      kept[out.kept[f]] = 1;
    else
      add(base.features[f]);
  }
  for (std::size_t f = 0; f < model.features.size(); ++f)
    if (!kept[f]) add(model.features[f]);
  return out;
}

}  // namespace remeshd
