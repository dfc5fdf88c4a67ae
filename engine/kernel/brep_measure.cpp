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
#include <algorithm>
#include <cmath>

#include "engine/kernel/brep_shapes.h"

namespace remeshd::kernel {
namespace {

constexpr double kTurning = 0.1;           // rad between points of an edge; 6 degrees are promised
constexpr double kMomentTolerance = 1e-9;  // relative
constexpr double kShortest = 1e-3;  // kernel units: below, a chord says nothing of a direction

Vec3 vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
Vec3 vec(const gp_Pnt& p) { return vec(p.XYZ()); }

/// Points of a curve dense enough for kTurning between the chords, by halving.
std::vector<Vec3> sample(const BRepAdaptor_Curve& curve, double first, double last) {
  struct Sample {
    double t;
    Vec3 p, tangent;
  };
  const auto at = [&](double t) {
    gp_Pnt p;
    gp_Vec d;
    curve.D1(t, p, d);
    return Sample{t, vec(p), d.Magnitude() > gp::Resolution() ? vec(d.Normalized().XYZ()) : Vec3{}};
  };
  const auto turns = [](const Sample& a, const Sample& b) {
    const Vec3 chord = b.p - a.p;
    if (norm(chord) < kShortest) return false;
    const Vec3 u = normalised(chord);
    return norm(u - a.tangent) > 0.5 * kTurning || norm(u - b.tangent) > 0.5 * kTurning;
  };
  std::vector<Vec3> points{at(first).p};
  std::vector<Sample> ahead{at(last), at(0.5 * (first + last))};
  Sample here = at(first);
  while (!ahead.empty()) {
    const Sample next = ahead.back();
    if (turns(here, next)) {
      ahead.push_back(at(0.5 * (here.t + next.t)));
      continue;
    }
    ahead.pop_back();
    points.push_back(next.p);
    here = next;
  }
  return points;
}

/// Gauss's rule of three points on each of so many parts of a curve.
std::vector<std::array<Vec3, 2>> integration_samples(const BRepAdaptor_Curve& curve, double first,
                                                     double last, std::size_t parts) {
  constexpr std::array<std::array<double, 2>, 3> kRule{
      {{-0.7745966692414834, 5.0 / 18}, {0, 8.0 / 18}, {0.7745966692414834, 5.0 / 18}}};
  const double step = (last - first) / static_cast<double>(parts);
  std::vector<std::array<Vec3, 2>> samples;
  for (std::size_t k = 0; k < parts; ++k)
    for (const auto& [x, weight] : kRule) {
      gp_Pnt p;
      gp_Vec d;
      curve.D1(first + step * (static_cast<double>(k) + 0.5 + 0.5 * x), p, d);
      samples.push_back({vec(p), step * weight * vec(d.XYZ())});
    }
  return samples;
}

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
  for (const int end : {0, 1}) {
    gp_Pnt p;
    gp_Vec d;
    curve.D1(end == 0 ? first : last, p, d);
    if (d.Magnitude() > gp::Resolution()) out.tangents[end] = vec(d.Normalized().XYZ());
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
      const int n = std::max(2, static_cast<int>(std::ceil((last - first) / kTurning)));
      for (int i = 0; i <= n; ++i)
        out.points.push_back(vec(curve.Value(first + (last - first) * i / n)));
      break;
    }
    default:
      out.length = GCPnts_AbscissaPoint::Length(curve, 1e-9);
      out.points = sample(curve, first, last);
      out.samples = integration_samples(curve, first, last, out.points.size() - 1);
      break;
  }
}

}  // namespace remeshd::kernel
