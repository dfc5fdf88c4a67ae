#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/boundary/entity_map.h"
#include "engine/kernel/paged_delaunay.h"
#include "engine/nodes/node_set.h"
#include "engine/nodes/surroundings.h"
#include "engine/plan/point_source.h"
#include "engine/remesh/master.h"

namespace remeshd {

/// The part of an original mesh that an edit works on, with numbers of its own. All of an inner
/// node's tets are in it; nodes at the rim have others too.
///
/// Its tets are whole pieces: the peeled Delaunay tets and the delivered tets have the same hull.
struct OriginalPart {
  std::vector<std::int32_t> nodes;    ///< by node: that of the original, ascending
  std::vector<std::uint8_t> inner;    ///< by node
  std::vector<Vec3> positions;        ///< as in the Delaunay master
  std::vector<Vec3> delivered_nodes;  ///< as the master gave them
  kernel::Delaunay mesh;
  kernel::PagedDelaunay::Cut cut;
  std::vector<Tet> tets;                    ///< peeled
  Pieces pieces;                            ///< of `tets` and `delivered`
  std::vector<Tet> delivered;               ///< delivered tets that these pieces have
  std::vector<std::int32_t> delivered_tet;  ///< by delivered tet: that of the original, ascending
  std::vector<std::int32_t> clusters;       ///< by cluster of `pieces`: the master's
  std::vector<std::uint8_t> inside;         ///< by slot of `mesh`: 1 if among `tets`
  std::vector<std::uint8_t> beyond;         ///< by element of `cut.beyond`: 1 if in the model
};

/// `inner`: by node of the original. `changing`: where nodes may move or come; null: nowhere that
/// is not at inner nodes.
OriginalPart cut_out(const Master& master, const PagedMesh& delivered,
                     const std::vector<std::uint8_t>& inner, const Surroundings* changing);

/// The nodes that an edit works on, and the part of the original that they came from.
struct LocalNodes {
  NodeSet nodes;            ///< `original`: nodes of `part`
  OriginalPart part;        ///< empty for a first mesh
  std::int32_t placed = 0;  ///< nodes below have their supports in the modified boundary
};

/// Cuts the part out of the original that lies within `reach` (length) of what changes: `near` are
/// the nodes that the plan made of the original's `looked_at` nodes, by their numbers in the
/// original, new ones too. With `reach` infinite all of the original is in it.
///
/// Nodes that are looked at keep their supports of the original; others that come along stand
/// before them and get theirs by `map`. Returns nothing where it has none for one.
std::optional<LocalNodes> localise(const NodeSet& near, std::span<const std::int32_t> looked_at,
                                   const Master& master, const Pages<Support>& supports,
                                   const PagedMesh& delivered, const EntityMap* map,
                                   const PointSource& source, double reach);

}  // namespace remeshd
