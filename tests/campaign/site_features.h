#pragma once

#include <string>
#include <vector>

#include "tests/campaign/draft.h"

namespace remeshd::campaign {

/// Adds bosses, holes, pockets and what is made of them on the site, one to three features; notes
/// them at the site. Sizes, walls and gaps are at least about one l where the site is large enough.
///
/// Returns the ids of the features; none where the site is too small.
std::vector<std::string> add_on_site(Draft& draft, std::size_t site);

/// The indices of the free sites.
std::vector<std::size_t> free_sites(const Draft& draft);

}  // namespace remeshd::campaign
