#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/tet_mesh.h"

namespace remeshd::campaign {

/// Which tets of a mesh a point lies in, by looking at all whose boxes are near.
class TetLocation {
 public:
  /// Keeps a reference.
  explicit TetLocation(const TetMesh& mesh);

  /// How many tets contain p in their interior or on their facets; 1 for almost all inner points.
  [[nodiscard]] int count(const Vec3& p) const;

 private:
  [[nodiscard]] std::array<int, 3> cell_of(const Vec3& p) const;

  const TetMesh& mesh_;
  Box box_;
  double cell_ = 1;
  std::array<int, 3> cells_{1, 1, 1};
  std::vector<std::vector<std::int32_t>> grid_;
};

}  // namespace remeshd::campaign
