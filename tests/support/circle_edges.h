#pragma once

#include "engine/revision/revision.h"

namespace remeshd::test {

/// The fewest mesh edges on a circle of the boundary, as those of a whole one: an arc that has as
/// many as its share of `whole`, rounded down, counts as having `whole`. Infinite where there are
/// no circles.
double fewest_edges_on_circles(const Revision& revision, int whole = 12);

}  // namespace remeshd::test
