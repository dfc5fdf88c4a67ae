#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/revision/delaunay_state.h"

namespace remeshd {

/// What clean-up made of a peeled Delaunay mesh. A tet that it left alone stands for itself; all
/// others are in cavities, in each of which the output tets may be exchanged for the Delaunay tets.
struct Cavities {
  std::vector<std::int32_t> same;    ///< by Delaunay tet: the same output tet, or -1
  std::vector<std::int32_t> of_tet;  ///< by Delaunay tet: its cavity; -1 if it stands for itself
  std::vector<Cavity> list;
};

/// How far a cavity goes.
enum class CavityExtent : std::uint8_t {
  /// Changed tets that share a facet, of either mesh, belong to one cavity. A tet that clean-up has
  /// turned over counts as the same.
  Connected,
  /// As Connected, with two differences. A tet that clean-up has turned over counts as changed. And
  /// where both meshes have a facet, with changed tets on the same sides of it, the tets on one
  /// side are not joined with those on the other, since either side may be exchanged alone. So
  /// cavities are the smallest whose Delaunay and output tets have the same hull.
  Least,
};

/// Finds the cavities between two meshes. Each has Delaunay tets, unless `delaunay` is empty.
/// `same`: by output tet the Delaunay tet with the same nodes where that is known, else -1; may be
/// empty. `node_count`: more than every node number of the tets.
Cavities find_cavities(std::span<const Tet> delaunay, std::span<const Tet> output,
                       std::span<const std::int32_t> same, std::size_t node_count,
                       CavityExtent extent, const Run& run);

}  // namespace remeshd
