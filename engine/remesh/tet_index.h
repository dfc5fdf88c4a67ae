#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// Finds a tet by its four nodes, whatever their order.
class TetIndex {
 public:
  explicit TetIndex(std::span<const Tet> tets);
  /// Index of the tet with these nodes, -1 if there is none.
  [[nodiscard]] std::int32_t find(const Tet& tet) const;

 private:
  std::vector<Tet> sorted_;
  std::vector<std::int32_t> table_;
};

/// The nodes of a tet in ascending order.
Tet sorted_nodes(Tet tet);

}  // namespace remeshd
