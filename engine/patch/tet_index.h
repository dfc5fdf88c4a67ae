#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/base/run.h"
#include "engine/mesh/grouping.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// Finds a tet by its four nodes, whatever their order. Tets are grouped by their smallest node, so
/// that look-ups of neighbouring tets are near each other in memory.
class TetIndex {
 public:
  /// `left_out`: by tet, 1 for those that are not to be found. `node_count`: more than every node
  /// number of the tets. `oriented`: a tet of the same nodes turned over is another one: clean-up
  /// may move a node across the facet that is opposite to it.
  TetIndex(std::span<const Tet> tets, std::span<const std::uint8_t> left_out,
           std::size_t node_count, bool oriented, Polling& poll);
  /// Index of the tet with these nodes, -1 if there is none.
  [[nodiscard]] std::int32_t find(const Tet& tet) const;

 private:
  struct Entry {
    std::array<std::int32_t, 3> others;  ///< ascending
    std::int32_t tet;
    bool even;  ///< whether the nodes in ascending order are an even permutation of the tet's
  };
  Grouping<Entry> entries_;  ///< by smallest node
  bool oriented_;
};

/// The nodes of a tet in ascending order, and whether that is an even permutation.
struct SortedNodes {
  friend bool operator==(const SortedNodes&, const SortedNodes&) = default;
  Tet nodes;
  bool even;
};
SortedNodes sorted_nodes(const Tet& tet);

}  // namespace remeshd
