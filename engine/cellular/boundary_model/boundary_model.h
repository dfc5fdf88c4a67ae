#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/base/surface.h"

namespace remeshd {

/// A feature's face, `hole1.wall`: index of the feature in history and name of its face.
struct FaceName {
  int feature = -1;
  std::string face;
  friend auto operator<=>(const FaceName&, const FaceName&) = default;
};

struct BoundaryVertex {
  Vec3 position;
  std::vector<int> edges;  ///< ascending
};

/// The curve of a model edge. Line and Circle are exact; Other is the polyline `points` of the
/// edge, refined by projection onto the surfaces of its two faces.
struct Curve {
  enum class Kind { Line, Circle, Other };
  Kind kind = Kind::Other;
  Vec3 origin;     ///< point on the line, or centre of the circle
  Vec3 direction;  ///< unit: along the line, or the circle's axis
  double radius = 0;
};

struct BoundaryEdge {
  Curve curve;
  /// Points on the curve from start to end, both included, dense (at most 6 degrees of turning
  /// between neighbours); a closed edge repeats its first point.
  std::vector<Vec3> points;
  int start = -1, end = -1;  ///< vertices; -1 both for a closed edge without a vertex
  std::vector<int> faces;    ///< the one or two faces it bounds, ascending
  double length = 0;         ///< exact
  bool rim = false;          ///< its faces share one surface, but different groups name them

  [[nodiscard]] bool closed() const { return start == end; }
  /// Unit direction in which it leaves one of its ends. Pre: two points at least.
  [[nodiscard]] Vec3 leaving(bool at_start) const {
    return normalised(at_start ? points[1] - points[0] : points[points.size() - 2] - points.back());
  }
};

struct BoundaryFace {
  Surface surface;
  bool reversed = false;   ///< true where the outward normal is minus that of `surface`
  double area = 0;         ///< exact
  std::vector<int> edges;  ///< ascending
  /// All feature faces that cover some part of it, the latest owner on the material side first.
  std::vector<FaceName> names;
  /// Triangulation, outward oriented, watertight with its neighbours' along shared edges.
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Unit normal of the face out of the material, at the point of its surface nearest to p.
inline Vec3 outward_normal(const BoundaryFace& face, const Vec3& p) {
  const Vec3 n = normal(face.surface, p);
  return face.reversed ? -n : n;
}

/// The merged boundary of a model: faces, edges and vertices that a mesh must represent. Coplanar
/// splits and seams are unified, so that they are no edges (Sect. 4.1), but for the rims of
/// faces that a group names.
///
/// Inv: all elements are ordered by geometry, never as the CAD kernel has them, so that the same
/// model gives the same value.
struct BoundaryModel {
  std::vector<BoundaryVertex> vertices;
  std::vector<BoundaryEdge> edges;
  std::vector<BoundaryFace> faces;
  Box bounds;
};

}  // namespace remeshd
