#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// The triangles of all faces of a boundary in a hierarchy of boxes, faces first. Safe from any
/// number of threads.
class TriangleTree {
 public:
  explicit TriangleTree(const BoundaryModel& boundary);

  struct Nearest {
    double distance;     ///< as it was given where nothing is nearer
    Vec3 at;             ///< the point that is nearest
    bool found = false;  ///< whether anything is nearer than that
  };
  /// What is nearest to p, if nearer than `within`, but for the faces left out.
  /// @param left_out  by face: not 0 where its triangles are
  [[nodiscard]] Nearest nearest(const Vec3& p, double within,
                                std::span<const std::uint8_t> left_out) const;

 private:
  using Triangle = std::array<Vec3, 3>;
  struct Node {
    Box box;
    std::int32_t begin = 0;   ///< of its triangles
    std::int32_t count = 0;   ///< of them; 0: it has two children
    std::int32_t second = 0;  ///< the other child; the first comes next
    std::int32_t face = -1;   ///< that all of its triangles are of; -1: of several
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
