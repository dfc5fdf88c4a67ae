#include "tests/campaign/parts/lost_nodes.h"

#include <algorithm>
#include <vector>

#include "engine/remesh/density.h"
#include "tests/support/changed_places.h"

namespace remeshd::campaign {

LostNodes lost_nodes(const Revision& base, const Revision& edited) {
  LostNodes result;
  const std::vector<std::uint8_t> stays = test::kept_nodes(base, edited);
  result.all = static_cast<int>(std::ranges::count(stays, 0));
  if (result.all == 0) return result;
  const test::ChangedPlaces changed(base, edited);
  const SizeField sizes = sizes_of(base, Run{});
  for (std::size_t n = 0; n < stays.size(); ++n) {
    const Vec3& p = base.output.mesh.nodes[n];
    const double local = sizes(p);
    if (stays[n] != 0 || changed.within(p, kFar * local)) continue;
    ++result.far;
    result.furthest = std::max(result.furthest, std::min(kNowhere, changed.distance_to(p) / local));
  }
  return result;
}

}  // namespace remeshd::campaign
