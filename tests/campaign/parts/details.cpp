#include "tests/campaign/parts/details.h"

#include <array>
#include <cmath>
#include <numbers>

#include "tests/campaign/draft.h"
#include "tests/support/cases.h"

namespace remeshd::campaign {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kPlaceTries = 12;
/// Of subtractive features beyond the surface they open, by the sheet's depth: faces do not
/// coincide.
constexpr double kBeyond = 0.1;

/// A detail in its own frame: z out of the material, the origin on the sheet.
class Detail {
 public:
  Detail(PartDraft& draft, const Sheet& sheet, double size)
      : draft_(draft), sheet_(sheet), size_(size), id_("d" + std::to_string(draft.serial + 1)) {}

  /// Where it stands: moved and turned on the sheet.
  [[nodiscard]] std::vector<Footprint> covered(const Transform& at) const {
    std::vector<Footprint> result = footprints_;
    for (Footprint& f : result)
      for (std::array<double, 2>* p : {&f.from, &f.to}) {
        const Vec3 moved = at.apply({(*p)[0], (*p)[1], 0});
        *p = {moved.x, moved.y};
      }
    return result;
  }
  void add_to(ModelSource& model, const Transform& at) const {
    for (const auto& [feature, frame] : features_) {
      model.features.push_back(feature);
      model.features.back().placement = placement_of(sheet_.frame * at * frame);
    }
    model.parameters.insert(model.parameters.end(), parameters_.begin(), parameters_.end());
  }

  void boss() {
    const double r = 0.5 * size_, h = size_ * between(0.4, 1.6);
    add("boss", Nature::Additive, "cylinder", {{"radius", r}, {"height", h}}, 0);
    cover(r, std::min(size_, h));
    if (draft_.chance(0.5)) drill(r * between(0.3, 0.55), h);
  }
  void taper() {
    const double r = 0.5 * size_, h = size_ * between(0.4, 1.2);
    add("taper", Nature::Additive, "cone",
        {{"radius_bottom", r}, {"radius_top", r * between(0.5, 0.85)}, {"height", h}}, 0);
    cover(r, std::min(size_, h));
  }
  void pad() {
    const double dx = size_ * between(1, 1.8), h = size_ * between(0.4, 1);
    add("pad", Nature::Additive, "block", {{"dx", dx}, {"dy", size_}, {"dz", h}}, 0);
    cover(std::hypot(0.5 * dx, 0.5 * size_), std::min(size_, h));
  }
  void rib() {
    const double long_ = size_ * between(4, 9), h = size_ * between(0.8, 2.5);
    add("rib", Nature::Additive, "block", {{"dx", long_}, {"dy", size_}, {"dz", h}}, 0);
    cover_along(0.5 * long_, 0.7 * size_, std::min(size_, h));
  }
  void pocket() {
    const double dx = size_ * between(1, 2), depth = blind(0.5 * size_, size_);
    add("pocket", Nature::Subtractive, "block",
        {{"dx", dx}, {"dy", size_}, {"dz", depth + beyond()}}, -depth);
    cover(std::hypot(0.5 * dx, 0.5 * size_), std::min(size_, depth));
  }
  void slot() {
    const double long_ = size_ * between(2, 4), depth = depth_of_hole();
    add("slot", Nature::Subtractive, "slot",
        {{"length", long_}, {"width", size_}, {"height", depth + beyond()}}, -depth);
    cover_along(0.5 * (long_ - size_), 0.5 * size_, std::min(size_, depth));
  }
  void hole() {
    const double r = 0.5 * size_;
    const double depth = depth_of_hole();
    add("hole", Nature::Subtractive, "cylinder", {{"radius", r}, {"height", depth + beyond()}},
        -depth);
    const double mouth = r * between(0.35, 0.7);
    const double kind = draft_.random.uniform();
    if (kind < 0.3) {
      const double sunk = std::min(0.5 * depth, r * between(0.6, 1.2));
      add("counterbore", Nature::Subtractive, "cylinder",
          {{"radius", r + mouth}, {"height", sunk + beyond()}}, -sunk);
    } else if (kind < 0.6 && mouth < 0.5 * depth) {
      add("chamfer", Nature::Subtractive, "cone",
          {{"radius_bottom", r},
           {"radius_top", r + mouth + beyond()},
           {"height", mouth + beyond()}},
          -mouth);
    }
    cover(kind < 0.6 ? r + mouth : r, kind < 0.6 ? mouth : std::min(size_, depth));
  }
  void groove() {
    const double r = size_ * between(1.5, 3), depth = blind(0.4 * size_, 0.9 * size_);
    FeatureSource ring = test::feature(id_ + "_groove", "revolution",
                                       {test::point(r, -depth), test::point(r + size_, -depth),
                                        test::point(r + size_, beyond()), test::point(r, beyond())},
                                       {{"angle", 360.0}});
    ring.nature = Nature::Subtractive;
    features_.emplace_back(std::move(ring), Transform{});
    cover(r + size_, std::min(size_, depth));
  }
  void dimple() {
    const double r = 0.5 * size_;
    const double above = std::max(0.3 * r, r - 0.6 * sheet_.depth);
    add("dimple", Nature::Subtractive, "sphere", {{"radius", r}}, above);
    cover(r, r - above);
  }
  void row() {
    const int count = 3 + static_cast<int>(draft_.random.below(5));
    const double pitch = size_ * between(1.7, 3);
    std::vector<Transform> at;
    for (int k = 0; k < count; ++k)
      at.push_back(shifted({}, pitch * (k - 0.5 * (count - 1)), 0, 0));
    const double detail = many(at);
    cover_along(0.5 * pitch * (count - 1), 0.5 * size_, detail);
  }
  /// `around`: its radius, of the middle of its holes; 0 where it may be any.
  void circle(double around) {
    const int count = 4 + static_cast<int>(draft_.random.below(7));
    const double needed = 1.7 * size_ * count / kTurn;
    const double r = around > 0 ? around : needed * between(1, 1.6);
    const int most = std::max(3, static_cast<int>(r * count / needed));
    const int n = std::min(count, most);
    std::vector<Transform> at;
    for (int k = 0; k < n; ++k) at.push_back(shifted(turned({}, 2, k * kTurn / n), r, 0, 0));
    const double detail = many(at);
    for (const Transform& t : at)
      footprints_.push_back({{t.m[3], t.m[7]}, {t.m[3], t.m[7]}, 0.5 * size_, detail});
  }

 private:
  double between(double lo, double hi) { return draft_.random.uniform(lo, hi); }
  [[nodiscard]] double beyond() const { return kBeyond * sheet_.depth; }
  /// A depth that leaves a wall below.
  double blind(double lo, double hi) {
    const double most = 0.6 * sheet_.depth;
    return std::min(most, between(lo, hi));
  }
  double depth_of_hole() {
    if (sheet_.through && draft_.chance(0.6)) return sheet_.depth + beyond();
    return blind(size_, 3 * size_);
  }

  void add(const std::string& name, Nature nature, const std::string& type,
           std::map<std::string, Scalar> parameters, double z) {
    FeatureSource feature =
        test::feature(std::string(id_).append("_").append(name), type, std::move(parameters));
    feature.nature = nature;
    features_.emplace_back(std::move(feature), shifted({}, 0, 0, z));
  }
  /// From the top of what stands `height` high down to somewhere.
  void drill(double r, double height) {
    const bool all = sheet_.through && draft_.chance(0.5);
    const double depth = all ? sheet_.depth + beyond() : -height * between(0.2, 0.6);
    add("drill", Nature::Subtractive, "cylinder",
        {{"radius", r}, {"height", depth + height + beyond()}}, -depth);
  }
  /// Holes or pins of the same size; half of the time the radius is a parameter of the model.
  double many(const std::vector<Transform>& at) {
    const bool pins = draft_.chance(0.3);
    const double height = pins ? size_ * between(0.5, 1.5) : depth_of_hole();
    Scalar radius = 0.5 * size_;
    if (draft_.chance(0.5)) {
      parameters_.push_back({id_ + "_radius", radius});
      radius = id_ + "_radius";
    }
    for (std::size_t k = 0; k < at.size(); ++k) {
      add((pins ? "pin" : "hole") + std::to_string(k),
          pins ? Nature::Additive : Nature::Subtractive, "cylinder",
          {{"radius", radius}, {"height", pins ? height : height + beyond()}}, 0);
      features_.back().second = shifted(at[k], 0, 0, pins ? 0 : -height);
    }
    return std::min(size_, height);
  }

  void cover(double radius, double detail) { footprints_.push_back({{}, {}, radius, detail}); }
  void cover_along(double half, double radius, double detail) {
    footprints_.push_back({{-half, 0}, {half, 0}, radius, detail});
  }

  PartDraft& draft_;
  const Sheet& sheet_;
  const double size_;
  const std::string id_;
  std::vector<std::pair<FeatureSource, Transform>> features_;
  std::vector<ParameterSource> parameters_;
  std::vector<Footprint> footprints_;
};

double size_of(PartDraft& draft, const Sheet& sheet, Scale scale) {
  switch (scale) {
    case Scale::Part:
      return sheet.width() * draft.random.uniform(0.12, 0.3);
    case Scale::Edge:
      return draft.length * draft.random.uniform(0.8, 2);
    case Scale::Fine:
      return draft.length * draft.random.uniform(0.25, 0.7);
  }
  return 0;
}

Transform somewhere(PartDraft& draft, const Sheet& sheet) {
  Random& random = draft.random;
  const double x = sheet.radius > 0 ? sheet.radius : sheet.half_x;
  const double y = sheet.radius > 0 ? sheet.radius : sheet.half_y;
  const double angle = draft.chance(0.7) ? 0.25 * kTurn * static_cast<double>(random.below(4))
                                         : random.uniform(0, kTurn);
  const double at_x = random.uniform(-x, x), at_y = random.uniform(-y, y);
  return turned(shifted({}, at_x, at_y, 0), 2, angle);
}

}  // namespace

bool add_detail(PartDraft& draft, Sheet& sheet, Scale scale) {
  using Make = void (Detail::*)();
  static constexpr std::array<Make, 10> kKinds{
      &Detail::boss, &Detail::hole, &Detail::row,   &Detail::pad,    &Detail::pocket,
      &Detail::rib,  &Detail::slot, &Detail::taper, &Detail::dimple, &Detail::groove};
  Detail detail(draft, sheet, size_of(draft, sheet, scale));
  // Round a hub, or about the middle of a disc, patterns are circles.
  const bool central = sheet.radius > 0 && scale != Scale::Part && draft.chance(0.3);
  if (central)
    detail.circle(draft.random.uniform(sheet.inner, sheet.radius));
  else if (scale != Scale::Part && draft.chance(0.2))
    detail.circle(0);
  else
    (detail.*kKinds[draft.random.below(kKinds.size() - (scale == Scale::Fine ? 1 : 0))])();
  for (int k = 0; k < kPlaceTries; ++k) {
    const Transform at = central ? Transform{} : somewhere(draft, sheet);
    const std::vector<Footprint> covered = detail.covered(at);
    if (!sheet.has_room(covered)) continue;
    detail.add_to(draft.model, at);
    sheet.taken.insert(sheet.taken.end(), covered.begin(), covered.end());
    ++draft.serial;
    return true;
  }
  return false;
}

}  // namespace remeshd::campaign
