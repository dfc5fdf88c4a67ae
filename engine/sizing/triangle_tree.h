#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// A bounding volume hierarchy of the triangles of a boundary: of faces, and below each face of its
/// triangles. Safe from any number of threads.
class TriangleTree {
 public:
  explicit TriangleTree(const BoundaryModel& boundary);

  struct Nearest {
    double distance;     ///< `within` where nothing is nearer
    Vec3 at;             ///< the nearest point of the triangles
    bool found = false;  ///< whether anything is nearer than `within`
  };
  /// The point nearest to p of all faces but those left out, if nearer than `within`.
  /// @param left_out  by face: not 0 where it is left out
  [[nodiscard]] Nearest nearest(const Vec3& p, double within,
                                std::span<const std::uint8_t> left_out) const;

 private:
  using Triangle = std::array<Vec3, 3>;
  struct Node {
    Box box;
    std::int32_t begin = 0;   ///< of its triangles
    std::int32_t count = 0;   ///< of them; 0: it has two children
    std::int32_t second = 0;  ///< the second child; the first is the next node
    std::int32_t face = -1;   ///< whose triangles all of these are; -1: of several faces
  };
  struct Face {
    Box box;
    std::int32_t id, begin, count;  ///< its triangles
  };
  class Search;

  void divide(std::span<Face> faces);
  void divide(std::span<Triangle> triangles, std::int32_t face);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace remeshd
