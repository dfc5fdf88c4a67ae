#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Curve2d.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Sinert.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "engine/kernel/brep_shapes.h"
#include "engine/kernel/curve_points.h"

namespace remeshd::kernel {
namespace {

constexpr double kMomentTolerance = 1e-9;  // relative

/// Whether Gauss's rule is exact to rounding on the face: its border is straight in parameters, or
/// of lines and circles in a plane. On other borders it errs by 1e-5 and refinement is worth its
/// tenfold time.
bool has_simple_border(const TopoDS_Face& face) {
  const bool plane = BRepAdaptor_Surface(face, /*Restriction=*/false).GetType() == GeomAbs_Plane;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    if (plane) {
      const GeomAbs_CurveType type = BRepAdaptor_Curve(edge).GetType();
      if (type != GeomAbs_Line && type != GeomAbs_Circle) return false;
    } else if (BRepAdaptor_Curve2d(edge, face).GetType() != GeomAbs_Line) {
      return false;
    }
  }
  return true;
}

}  // namespace

FaceMoments moments_of(const TopoDS_Face& face, const Vec3& reference) {
  BRepGProp_Face integrand(face);
  BRepGProp_Domain domain(face);
  const gp_Pnt origin(reference.x, reference.y, reference.z);
  if (has_simple_border(face)) {
    const BRepGProp_Sinert surface(integrand, domain, origin);
    domain.Init(face);
    const BRepGProp_Vinert volume(integrand, domain, origin);
    return {surface.Mass(), vec(surface.CentreOfMass()), volume.Mass()};
  }
  const BRepGProp_Sinert surface(integrand, domain, origin, kMomentTolerance);
  domain.Init(face);
  const BRepGProp_Vinert volume(integrand, domain, origin, kMomentTolerance);
  return {surface.Mass(), vec(surface.CentreOfMass()), volume.Mass()};
}

void measure_edge(const TopoDS_Edge& edge, BrepEdge& out) {
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter();
  const double last = curve.LastParameter();
  const auto at = [&](double t) {
    gp_Pnt p;
    gp_Vec d;
    curve.D1(t, p, d);
    return CurvePoint{vec(p), vec(d.XYZ())};
  };
  for (const int end : {0, 1}) {
    const Vec3 d = at(end == 0 ? first : last).derivative;
    if (norm(d) > gp::Resolution()) out.tangents[end] = normalised(d);
  }
  switch (curve.GetType()) {
    case GeomAbs_Line:
      out.kind = BrepEdge::Kind::Line;
      out.length = last - first;
      out.points = {vec(curve.Value(first)), vec(curve.Value(last))};
      break;
    case GeomAbs_Circle: {
      const gp_Circ circle = curve.Circle();
      out.kind = BrepEdge::Kind::Circle;
      out.centre = vec(circle.Location());
      out.axis = vec(circle.Axis().Direction().XYZ());
      out.radius = circle.Radius();
      out.length = out.radius * (last - first);
      const int n = steps_of(last - first, kPointTurning);
      for (int i = 0; i <= n; ++i)
        out.points.push_back(vec(curve.Value(first + (last - first) * i / n)));
      break;
    }
    default:
      out.length = GCPnts_AbscissaPoint::Length(curve, 1e-9);
      out.points = points_by_halving(at, first, last, kShortestChord);
      out.samples = integration_samples(at, first, last, out.points.size() - 1);
      break;
  }
}

}  // namespace remeshd::kernel
