#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/revision/delaunay_state.h"

namespace remeshd {

/// What clean-up made of a peeled Delaunay mesh, as cavities that may be exchanged: a tet that it
/// left alone stands for itself, all others are in cavities.
struct Cavities {
  std::vector<std::int32_t> same;    ///< by Delaunay tet: the same output tet, or -1
  std::vector<std::int32_t> of_tet;  ///< by Delaunay tet: its cavity, -1 where `same` is not
  std::vector<Cavity> list;
};

/// How far a cavity goes.
enum class CavityExtent : std::uint8_t {
  /// Changed tets of one mesh that share a facet belong to one cavity.
  Connected,
  /// But for a facet that both meshes have: there those on one side of it do, of either mesh, for
  /// they may be exchanged without what is on the other. The least cavities with one hull.
  Least,
};

/// Cavities each of which has Delaunay tets, if there are any. `same`: by output tet the Delaunay
/// tet with the same nodes where that is known, else -1; may be empty. `node_count`: above every
/// node of the tets.
Cavities find_cavities(std::span<const Tet> delaunay, std::span<const Tet> output,
                       std::span<const std::int32_t> same, std::size_t node_count,
                       CavityExtent extent, const Run& run);

}  // namespace remeshd
