#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/kernel/tetgen.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// The control mesh: a constrained Delaunay mesh of the model's triangulated boundary, with point
/// location, 50-150 ns a query. It represents the boundary to within the chords of the
/// triangulation.
///
/// Source: Sect. 3.1.
class ControlMesh {
 public:
  /// Throws what run_tetgen throws; Error(TETGEN_REFUSED) where the mesh does not fill the
  /// boundary.
  static ControlMesh build(const BoundaryModel& boundary, const Run& run,
                           const kernel::TetGenLimits& limits = {});

  /// Whether p lies in the mesh, its boundary included (to 1e-12 of the diagonal). Thread-safe.
  [[nodiscard]] bool inside(const Vec3& p) const;
  [[nodiscard]] double volume() const { return volume_; }
  /// The tets in material.
  [[nodiscard]] const TetMesh& mesh() const { return mesh_; }

 private:
  /// A facet's plane: positive inside of the tet.
  struct Plane {
    Vec3 normal;
    double offset;
  };
  using TetPlanes = std::array<Plane, 4>;

  /// What the octree is built from.
  struct Scene;
  void add_planes();
  void divide(const Scene& scene, std::size_t node, const Vec3& centre, const Vec3& half, int depth,
              const std::vector<std::int32_t>& tets, const std::vector<std::int32_t>& facets);
  [[nodiscard]] bool in_tet(std::int32_t tet, const Vec3& p) const;

  TetMesh mesh_;
  std::vector<TetPlanes> planes_;
  double volume_ = 0;
  double tolerance_ = 0;
  Box bounds_;
  Vec3 steps_per_length_;  ///< finest octree cells per length

  // An octree over `bounds_`. A node of value n >= 0 has its children at n..n+7; others are leaves:
  // outside, inside, or ~k - 2 for the tets leaf_tets_[leaf_first_[k]..leaf_first_[k + 1]).
  std::vector<std::int32_t> nodes_;
  std::vector<std::int32_t> leaf_first_;
  std::vector<std::int32_t> leaf_tets_;
};

/// The triangulation of all faces as one closed surface; the points of neighbouring faces along
/// their common edges, equal to the bit, become one.
kernel::TetGenSurface joined_surface(const BoundaryModel& boundary);

}  // namespace remeshd
