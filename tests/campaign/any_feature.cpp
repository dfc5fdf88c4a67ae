#include "tests/campaign/any_feature.h"

#include <algorithm>
#include <vector>

namespace remeshd::campaign {

std::string add_any_feature(Draft& d, const Transform& frame, double r, double depth, double l) {
  const double s = l * d.log_uniform(0.5, 8);
  const double t = s * d.random.uniform(0.3, 1.5);
  const Nature nature = d.chance(0.55) ? Nature::Additive : Nature::Subtractive;
  Transform at = shifted(frame, d.random.uniform(-2, 2) * r, d.random.uniform(-2, 2) * r,
                         d.random.uniform(-0.7, 0.2) * std::max(depth, r));
  if (d.chance(0.7)) at = at * random_rotation(d.random);
  switch (d.random.below(8)) {
    case 0:
      return d.add("block", nature, at,
                   {{"dx", s}, {"dy", t}, {"dz", s * d.random.uniform(0.3, 2)}});
    case 1:
      return d.add("cylinder", nature, at, {{"radius", 0.5 * s}, {"height", 2 * t}});
    case 2:
      return d.add("cone", nature, at,
                   {{"radius_bottom", 0.6 * s}, {"radius_top", 0.3 * t}, {"height", s}});
    case 3:
      return d.add("sphere", nature, at, {{"radius", 0.6 * s}});
    case 4:
      return d.add("torus", nature, at,
                   {{"major_radius", s}, {"minor_radius", s * d.random.uniform(0.2, 0.6)}});
    case 5: {
      std::vector<ProfileEntry> profile = polygon(3 + static_cast<int>(d.random.below(6)), 0.6 * s);
      if (d.chance(0.5))
        for (std::size_t k = 0; k < profile.size(); k += 2) {
          profile[k].x = 0.6 * std::get<double>(profile[k].x);
          profile[k].y = 0.6 * std::get<double>(profile[k].y);
        }
      return d.add_outline("prism", nature, at, profile, {{"height", t}});
    }
    case 6: {
      const std::vector<ProfileEntry> profile{
          {0.3 * s, 0.0, {}}, {s, 0.0, {}}, {0.3 * s, t, std::array<Scalar, 2>{0.9 * s, 0.8 * t}}};
      return d.add_outline("revolution", nature, at, profile,
                           {{"angle", d.chance(0.5) ? 360 : d.random.uniform(20, 340)}});
    }
    default:
      return d.add("slot", nature, at,
                   {{"length", 1.2 * s + 0.1 * t}, {"width", 0.5 * s}, {"height", t}});
  }
}

}  // namespace remeshd::campaign
