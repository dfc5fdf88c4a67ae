#pragma once

#include <string>
#include <vector>

#include "tests/campaign/draft.h"

namespace remeshd::campaign {

/// What makes a model hard to mesh, one family each.
enum class Trouble {
  Tangent,     ///< surfaces of two features that touch without crossing
  Coincident,  ///< faces of two features that lie on each other
  Wedge,       ///< material or void that runs out at 8 to 30 degrees
  Thin,        ///< walls and gaps below l
  Rim,         ///< holes and bosses that cut a rim or merge with others
  Small,       ///< pins, holes and steps below l
  Soup,        ///< any type anywhere, turned in any way
};
inline constexpr int kTroubles = 7;

/// Adds one to five features of the family about the site, constructed so that the trouble is there
/// by the numbers. Returns their ids.
std::vector<std::string> add_trouble(Draft& draft, Trouble family, const Site& site);

}  // namespace remeshd::campaign
