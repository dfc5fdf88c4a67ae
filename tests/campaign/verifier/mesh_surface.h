#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/tet_mesh.h"
#include "engine/model/solid.h"

namespace remeshd::campaign {

/// The boundary of a mesh as triangles, found from the tets alone, with how far it may be from the
/// model's: what chords cut off curved faces and edges.
class MeshSurface {
 public:
  /// `tiny`: distance within which a node lies on a surface.
  MeshSurface(const TetMesh& mesh, const std::vector<Triangle>& facets,
              const Membership& membership, double tiny);

  struct Nearest {
    double distance;
    double allowed;  ///< for a point of the model's boundary, by the chords round the facet
    std::int32_t facet;
  };
  /// The facet whose allowance, `slack` times, p is least beyond; any within it if there is one:
  /// the nearest may be a plane's beside a coarse facet of the curved face that p lies on. `far`:
  /// nothing further off than this is looked for; -1 then.
  [[nodiscard]] Nearest least_beyond(const Vec3& p, double slack, double far) const;

  [[nodiscard]] const std::vector<Triangle>& facets() const { return facets_; }
  [[nodiscard]] double allowed(std::int32_t facet) const { return allowed_[facet]; }
  /// The most that an edge of the facet is off the curve in which two surfaces meet that both of
  /// its ends lie on, 0 where there is none. Where surfaces meet at a small angle this is far more
  /// than the chord's rise over either of them.
  [[nodiscard]] double rim_rise(std::int32_t facet) const { return rim_rise_[facet]; }
  /// The chord's rise over the facet itself, 0 where it is flat on a plane.
  [[nodiscard]] double rise(std::int32_t facet) const { return rise_[facet]; }
  /// Longest edge of all facets.
  [[nodiscard]] double longest() const { return longest_; }

 private:
  void find_surfaces(const Membership& membership);
  void measure_rises();
  void measure_rim_rises();
  void build_grid();
  [[nodiscard]] std::array<int, 3> cell_of(const Vec3& p) const;
  [[nodiscard]] Nearest measure(std::int32_t facet, const Vec3& p) const;

  const TetMesh& mesh_;
  std::vector<Triangle> facets_;
  double tiny_;
  std::vector<std::vector<const Surface*>> on_;  ///< of boundary nodes: what they lie on
  std::vector<double> rise_, rim_rise_, allowed_;
  double longest_ = 0, most_allowed_ = 0;
  Box box_;
  double cell_ = 1;
  std::array<int, 3> cells_{1, 1, 1};
  std::vector<std::vector<std::int32_t>> grid_;
};

/// How far the middle of the chord from a to b is off the curve in which the surfaces meet; 0 where
/// they are tangent or do not meet near it. Both ends lie on both surfaces.
double rise_over_intersection(const Surface& one, const Surface& other, const Vec3& a,
                              const Vec3& b);

/// Nearest point of a triangle.
Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace remeshd::campaign
