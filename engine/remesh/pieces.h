#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// Delaunay tets and the delivered tets that clean-up put in their place, with the same hull.
struct Cluster {
  friend bool operator==(const Cluster&, const Cluster&) = default;
  std::vector<std::int32_t> delaunay;
  std::vector<std::int32_t> delivered;
};

/// What clean-up made of a peeled Delaunay mesh, as exchangeable pieces: a tet that it left alone
/// stands for itself, all others are in clusters.
struct Pieces {
  std::vector<std::int32_t> same;     ///< by Delaunay tet: the same delivered tet, or -1
  std::vector<std::int32_t> cluster;  ///< by Delaunay tet: its cluster, -1 where `same` is not
  std::vector<Cluster> clusters;
};

/// Tets that share a facet, on either side of the exchange, belong to one cluster. `same`: by
/// delivered tet the Delaunay tet with the same nodes where that is known, else -1; may be empty.
/// `node_count`: above every node of the tets.
Pieces find_pieces(std::span<const Tet> delaunay, std::span<const Tet> delivered,
                   std::span<const std::int32_t> same, std::size_t node_count, const Run& run);

}  // namespace remeshd
