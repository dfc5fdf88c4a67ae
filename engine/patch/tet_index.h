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
  /// number of the tets.
  TetIndex(std::span<const Tet> tets, std::span<const std::uint8_t> left_out,
           std::size_t node_count, Polling& poll);
  /// Index of the tet with these nodes, -1 if there is none.
  [[nodiscard]] std::int32_t find(const Tet& tet) const;

 private:
  struct Entry {
    std::array<std::int32_t, 3> others;  ///< ascending
    std::int32_t tet;
  };
  Grouping<Entry> entries_;  ///< by smallest node
};

/// The nodes of a tet in ascending order.
Tet sorted_nodes(Tet tet);

}  // namespace remeshd
