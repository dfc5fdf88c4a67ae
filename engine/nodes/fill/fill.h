#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/inside_test.h"
#include "engine/base/run.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

struct FillOptions {
  double edge_length = 0;  ///< target; of `fill_lattice` only for its first try at a count
  double density = 0;      ///< nodes per volume
  std::optional<std::uint32_t> count;  ///< instead of the density: this many nodes in all
  std::uint64_t seed = 1;
};

/// Puts new nodes into the part of the boxes where `inside` holds, at the corners and centres of a
/// body-centred cubic lattice, each jittered a little. Such a start is nearly an optimal Delaunay
/// mesh already: after five iterations of the loop the mean volume-length measure is .85 to .90,
/// where a random start ends at .82 to .85 after fifteen.
///
/// The lattice is turned against the axes, so that no flat face of a usual model lies along its
/// planes and a thin slab gets its share of nodes wherever it stands.
///
/// Source: Labelle & Shewchuk 2007 for the lattice's tets.
std::vector<Vec3> fill_lattice(const std::vector<Box>& boxes, const InsideTest& inside,
                               const FillOptions& options, const Run& run);

/// The same for a field that is not even, without a count. The cubes of the lattice are the roots
/// of octrees that are divided as the field says; their corners and centres are the places for
/// nodes. Where these stand too close together those of the larger cubes are left out.
///
/// Throws Error(InvalidArgument) `MESH_TOO_LARGE` where there are over four times `run.max_nodes`.
std::vector<Vec3> fill_graded(const std::vector<Box>& boxes, const InsideTest& inside,
                              const SizeField& sizes, std::uint64_t seed, const Run& run);

/// The same with random nodes, spread evenly: a grid of half the edge length is traversed in
/// serpentine order, every grid cell with its centre inside receives its share, and the fraction of
/// a node that is left is carried over to the next.
///
/// Source: Sect. 3.2 and 7 (Alliez et al. 2005).
std::vector<Vec3> fill_random(const std::vector<Box>& boxes, const InsideTest& inside,
                              const FillOptions& options, const Run& run);

}  // namespace remeshd
