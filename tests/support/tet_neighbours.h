#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/tet_mesh.h"

namespace remeshd::test {

/// For each tet the tets across its four facets (facet i lies opposite corner i); -1 where the
/// facet is exposed. Where more than two tets share a facet, the surplus ones count as exposed.
std::vector<std::array<std::int32_t, 4>> tet_neighbours(std::span<const Tet> tets,
                                                        std::size_t node_count);

}  // namespace remeshd::test
