#include "engine/kernel/primitives.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GeomAbs_SurfaceType.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Circ.hxx>

#include <cmath>

#include "engine/base/angle.h"
#include "engine/base/error.h"
#include "engine/kernel/brep_shapes.h"

namespace remeshd::kernel {
namespace {

using Labels = std::vector<std::pair<TopoDS_Shape, std::string>>;

/// Runs a builder and turns its exceptions into Errors.
template <typename Build>
Brep built(Build build) {
  try {
    return build();
  } catch (const Standard_Failure& failure) {
    throw error::kernel_failure(failure.GetMessageString());
  }
}

/// The plane of a profile: where its first and second coordinates go.
struct ProfilePlane {
  gp_Dir first, second;
  [[nodiscard]] gp_Pnt at(const std::array<double, 2>& p, double scale) const {
    return gp_Pnt(scale * (p[0] * first.XYZ() + p[1] * second.XYZ()));
  }
};

struct ProfileFace {
  TopoDS_Face face;
  std::vector<TopoDS_Edge> edges;  ///< by side
};

ProfileFace make_face(std::span<const ProfileCurve> profile, const ProfilePlane& plane,
                      double scale) {
  ProfileFace out;
  std::vector<TopoDS_Vertex> corners;
  BRep_Builder builder;
  for (const ProfileCurve& side : profile) {
    builder.MakeVertex(corners.emplace_back(), plane.at(side.from, scale), Precision::Confusion());
  }
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const ProfileCurve& side = profile[i];
    const TopoDS_Vertex& from = corners[i];
    const TopoDS_Vertex& to = corners[(i + 1) % profile.size()];
    if (side.arc) {
      const gp_Dir up = plane.first.Crossed(plane.second);
      const gp_Circ circle(
          gp_Ax2(plane.at(side.centre, scale), side.counter_clockwise ? up : up.Reversed()),
          side.radius * scale);
      out.edges.push_back(BRepBuilderAPI_MakeEdge(circle, from, to).Edge());
    } else {
      out.edges.push_back(BRepBuilderAPI_MakeEdge(from, to).Edge());
    }
    wire.Add(out.edges.back());
  }
  const gp_Pln support(gp_Ax3(gp_Pnt(0, 0, 0), plane.first.Crossed(plane.second), plane.first));
  out.face = BRepBuilderAPI_MakeFace(support, wire.Wire(), /*Inside=*/true).Face();
  return out;
}

gp_Pnt middle(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  return curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
}

int index_in(const TopoDS_Shape& solid, const TopoDS_Shape& face) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  return faces.FindIndex(face);
}

bool on_axis(const ProfileCurve& side) { return !side.arc && side.from[0] == 0 && side.to[0] == 0; }

/// Labels the face that the point lies on.
void label_face_at(const TopoDS_Shape& solid, const gp_Pnt& p, const std::string& label,
                   Labels& labels) {
  const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(p);
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    const BRepExtrema_DistShapeShape gap(vertex, it.Current());
    if (gap.IsDone() && gap.Value() < 10 * Precision::Confusion())
      labels.emplace_back(it.Current(), label);
  }
}

Brep make_round(const TopoDS_Shape& solid, double scale) {
  Labels labels;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    const BRepAdaptor_Surface surface(TopoDS::Face(it.Current()));
    const bool flat = surface.GetType() == GeomAbs_Plane;
    const bool low = flat && surface.Plane().Location().Z() <= 0;
    labels.emplace_back(it.Current(), !flat ? "wall" : low ? "bottom" : "top");
  }
  return describe_primitive(solid, scale, labels);
}

Brep make_closed(const TopoDS_Shape& solid, double scale) {
  Labels labels;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
    labels.emplace_back(it.Current(), "surface");
  return describe_primitive(solid, scale, labels);
}

}  // namespace

Brep make_prism(std::span<const ProfileCurve> profile, double height, double scale) {
  return built([&] {
    const ProfileFace base = make_face(profile, {gp::DX(), gp::DY()}, scale);
    BRepPrimAPI_MakePrism sweep(base.face, gp_Vec(0, 0, height * scale));
    Labels labels{{sweep.FirstShape(), "bottom"}, {sweep.LastShape(), "top"}};
    for (std::size_t i = 0; i < profile.size(); ++i)
      for (const TopoDS_Shape& face : sweep.Generated(base.edges[i]))
        labels.emplace_back(face, profile[i].label);
    return describe_primitive(sweep.Shape(), scale, labels);
  });
}

Brep make_revolution(std::span<const ProfileCurve> profile, double angle, double scale) {
  return built([&] {
    const ProfileFace base = make_face(profile, {gp::DX(), gp::DZ()}, scale);
    const bool full = angle >= kTurn - 1e-12;
    const gp_Ax1 axis(gp_Pnt(0, 0, 0), gp::DZ());
    BRepPrimAPI_MakeRevol sweep = full ? BRepPrimAPI_MakeRevol(base.face, axis)
                                       : BRepPrimAPI_MakeRevol(base.face, axis, angle);
    Labels labels;
    if (!full) labels = {{sweep.FirstShape(), "start"}, {sweep.LastShape(), "end"}};
    gp_Trsf half_way;
    half_way.SetRotation(axis, 0.5 * (full ? kTurn : angle));
    for (std::size_t i = 0; i < profile.size(); ++i) {
      if (on_axis(profile[i])) continue;  // sweeps no face
      bool found = false;
      for (const TopoDS_Shape& face : sweep.Generated(base.edges[i])) {
        labels.emplace_back(face, profile[i].label);
        found = index_in(sweep.Shape(), face) > 0;
      }
      // OCCT's history lacks the flat faces of a full turn: look for the face that the side's
      // middle passes through half-way.
      if (!found)
        label_face_at(sweep.Shape(), middle(base.edges[i]).Transformed(half_way), profile[i].label,
                      labels);
    }
    return describe_primitive(sweep.Shape(), scale, labels);
  });
}

double shortest_edge(double scale) { return Precision::Confusion() / scale; }

Brep make_cone(double radius_bottom, double radius_top, double height, double scale) {
  return built([&] {
    // A cone of radii that are equal within its tolerance is an error to OCCT.
    if (std::fabs(radius_bottom - radius_top) <= shortest_edge(scale))
      return make_round(BRepPrimAPI_MakeCylinder(radius_bottom * scale, height * scale).Solid(),
                        scale);
    return make_round(
        BRepPrimAPI_MakeCone(radius_bottom * scale, radius_top * scale, height * scale).Solid(),
        scale);
  });
}

Brep make_sphere(double radius, double scale) {
  return built([&] { return make_closed(BRepPrimAPI_MakeSphere(radius * scale).Solid(), scale); });
}

Brep make_torus(double major_radius, double minor_radius, double scale) {
  return built([&] {
    return make_closed(BRepPrimAPI_MakeTorus(major_radius * scale, minor_radius * scale).Solid(),
                       scale);
  });
}

}  // namespace remeshd::kernel
