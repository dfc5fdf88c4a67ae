#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/run.h"
#include "engine/base/vec.h"

namespace remeshd::kernel {

struct BrepShapes;  ///< the CAD kernel's own shapes, element by element

/// A region of volume, closed by faces.
struct BrepCell {
  std::vector<int> faces;  ///< ascending
  double volume = 0;       ///< exact
};

/// A face between two cells, or between a cell and the outside (-1).
struct BrepFace {
  std::array<int, 2> cells{-1, -1};  ///< [0] lies behind the triangles, [1] in front
  std::vector<int> edges;            ///< ascending; one with this face on both sides twice
  double area = 0;                   ///< exact
  /// Of the cone over the face from Brep::reference, exact; positive where that is behind the face.
  double swept_volume = 0;
  Vec3 centroid;
  std::string label;  ///< `wall`, `side3`; of a primitive's faces only
  /// Indices into Brep::points; counter-clockwise seen from cells[1]. Watertight along edges.
  std::vector<std::array<int, 3>> triangles;

  /// Reverses the triangles and `swept_volume`; `cells` stay as they are.
  void turn_over() {
    for (auto& triangle : triangles) std::swap(triangle[1], triangle[2]);
    swept_volume = -swept_volume;
  }
};

/// A curve between two vertices (the same vertex twice if closed). Seams are edges here.
struct BrepEdge {
  enum class Kind { Line, Circle, Other };
  Kind kind = Kind::Other;
  std::array<int, 2> vertices{-1, -1};
  double length = 0;             ///< exact
  Vec3 centre, axis;             ///< circles; the points turn counter-clockwise about the axis
  double radius = 0;             ///< circles
  std::array<Vec3, 2> tangents;  ///< unit, at start and end, from start to end
  std::vector<Vec3> points;      ///< from start to end, at most 6 degrees of turning between two
  std::vector<int> chain;        ///< its polyline in the triangulation: indices into Brep::points
  /// Of Kind::Other: quadrature points on the curve, each with its weighted tangent vector, so that
  /// an integral along the curve is a sum.
  std::vector<std::array<Vec3, 2>> samples;

  /// The middle one of its points, or halfway between the two in the middle.
  [[nodiscard]] Vec3 middle() const {
    return 0.5 * (points[(points.size() - 1) / 2] + points[points.size() / 2]);
  }
};
/// The line from vertex a, at p, to vertex b, at q.
BrepEdge straight_edge(int a, int b, const Vec3& p, const Vec3& q);

struct BrepVertex {
  Vec3 position;
};

/// A non-manifold boundary representation: a primitive, or the result of a general fuse.
///
/// Immutable once made, so that threads may share it. The CAD kernel works in a length unit of its
/// own: model lengths times `scale`, a power of two that keeps its absolute tolerance of 1e-7 small
/// against any model. All numbers here are in the model's unit.
///
/// Inv: elements of a fuse are ordered by geometry, never by the CAD kernel. A primitive has only
/// its cell, its incidences, labels and shapes; measures and triangles come with the fuse.
class Brep {
 public:
  std::vector<BrepCell> cells;
  std::vector<BrepFace> faces;
  std::vector<BrepEdge> edges;
  std::vector<BrepVertex> vertices;
  std::vector<Vec3> points;  ///< of the triangulation; the first are the vertices
  Vec3 reference;            ///< see BrepFace::swept_volume
  double scale = 1;
  std::shared_ptr<const BrepShapes> shapes;
};

/// The scale for a model of this diagonal (model's unit, positive).
double unit_scale(double diagonal);

/// Some cells of a B-rep, at a place.
struct Part {
  const Brep* brep = nullptr;
  std::vector<int> cells;
  Transform where;  ///< rigid
};

/// An element of a part.
struct Source {
  int part = -1;
  int element = -1;  ///< index in the part's Brep
  friend auto operator<=>(const Source&, const Source&) = default;
};

/// A general fuse with its history: for each element of `brep` the elements of the parts that cover
/// it, ascending. Edges and vertices where parts cross have none.
struct Fusion {
  Brep brep;
  std::vector<std::vector<Source>> cells, faces, edges, vertices;
};

/// Splits all parts by each other and merges what coincides; nothing is taken away (a non-regular
/// union). Cells of one part must not overlap.
///
/// `reference` becomes that of the result; without one a vertex does. The scale is the first
/// part's.
///
/// Throws Error(KERNEL_FAILURE) where the CAD kernel raises an alert, with the place unless it is
/// unknown, Error(Cancelled).
/// Source: BOPAlgo_PaveFiller and BOPAlgo_Builder of OpenCASCADE, with no glue, no fuzzy value.
Fusion general_fuse(std::span<const Part> parts, const Run& run,
                    const std::optional<Vec3>& reference = {});

}  // namespace remeshd::kernel
