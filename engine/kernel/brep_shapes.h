#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/kernel/brep.h"

class Message_ProgressRange;
class TopoDS_Edge;
class TopoDS_Face;
class TopoDS_Shape;
class gp_Pnt;
class gp_XYZ;

namespace remeshd::kernel {

/// Reads every element of a CAD shape, measures and triangulates it, and orders all of it by
/// geometry. The shape is the Brep's own from then on: triangulating changes it.
///
/// Throws Error(KERNEL_FAILURE), with a place if one is known, where the shape holds no solid, a
/// face of it bounds no solid, two solids overlap, or a face cannot be triangulated;
/// Error(Cancelled).
Brep describe(const TopoDS_Shape& shape, double scale, const Run& run,
              const std::optional<Vec3>& reference);

/// Reads a feature's solid: incidences, and the names of its faces. No measures, no triangles, no
/// order, because a primitive is only there to be fused.
Brep describe_primitive(const TopoDS_Shape& solid, double scale,
                        const std::vector<std::pair<TopoDS_Shape, std::string>>& labels);

struct FaceMoments {
  double area = 0;
  Vec3 centroid;
  double swept_volume = 0;  ///< of the cone to the reference point, positive where that is behind
};
/// Integrals over a face, exact to 1e-9, with one reference point for all faces: BRepGProp's own
/// entry takes another one for each, and its results do not add up to volumes.
FaceMoments moments_of(const TopoDS_Face& face, const Vec3& reference);

/// Fills in all of a BrepEdge that its curve tells, kernel units.
void measure_edge(const TopoDS_Edge& edge, BrepEdge& out);

/// A node of the polyline that stands for an edge.
struct EdgeNode {
  int node = -1;         ///< in Brep::points
  double parameter = 0;  ///< of the edge's curve
};
using EdgeChains = std::vector<std::vector<EdgeNode>>;  ///< by edge, from start to end

/// Triangulates all faces from polylines of their edges, which it fills in, and nodes of its own
/// inside, kernel units. Returns the faces that it could not triangulate, as where polylines cross.
std::vector<int> mesh_faces(Brep& brep, EdgeChains& chains, const Run& run);

/// Triangulates the faces `bad` anew, from the polylines of their edges and nodes of its own
/// inside. Where polylines cross, as at edges that nearly touch, their segments are split opposite
/// each other's nodes, else in the middle, and all faces at these edges are triangulated anew.
/// Kernel units.
///
/// Returns false, with the Brep's triangles of no use, where that does not succeed.
bool mend_faces(Brep& brep, EdgeChains& chains, const std::vector<int>& bad);

/// Fills in points, triangles and the edges' chains, kernel units.
///
/// Throws Error(KERNEL_FAILURE) with the place, in the model's unit by `scale`; Error(Cancelled).
void triangulate(Brep& brep, const TopoDS_Shape& shape, double scale, const Run& run);

/// Calls `work`, which hands the range to the CAD kernel, so that a stop request interrupts it.
///
/// Throws Error(Cancelled) where a stop was requested.
void with_progress(const Run& run, const std::function<void(const Message_ProgressRange&)>& work);

/// A point on a shape, kernel units: inside one of its edges where it has any. Nothing where the
/// shape has no geometry.
std::optional<Vec3> point_on(const TopoDS_Shape& shape);
std::optional<Vec3> in_model_units(const std::optional<Vec3>& p, double scale);

Vec3 vec(const gp_XYZ& p);
Vec3 vec(const gp_Pnt& p);
/// Appends a point to Brep::points and returns its index.
int add_point(Brep& brep, const gp_Pnt& p);

enum class Element { Cell, Face, Edge, Vertex };

/// The CAD shape behind an element of a Brep.
const TopoDS_Shape& shape_of(const Brep& brep, Element kind, int index);
/// The CAD shape of a face, with forward orientation.
TopoDS_Face face_shape(const Brep& brep, int face);
/// The element with this CAD shape, whatever its orientation; -1 if there is none.
int index_of(const Brep& brep, Element kind, const TopoDS_Shape& shape);

}  // namespace remeshd::kernel
