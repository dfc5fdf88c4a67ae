#include <APIHeaderSection_MakeHeader.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <GeomToStep_MakeSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Interface_HArray1OfHAsciiString.hxx>
#include <Interface_Static.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepGeom_Surface.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine/base/error.h"
#include "engine/kernel/brep_shapes.h"
#include "engine/kernel/step/exchange_text.h"
#include "engine/kernel/step/skin_solid.h"
#include "engine/kernel/step/step_file.h"
#include "engine/kernel/step/step_session.h"

namespace remeshd::kernel {
namespace {

struct ArcSpans {
  double most = 0.25;       ///< rad, of a span
  double same_knot = 1e-6;  ///< rad
};
constexpr ArcSpans kSpans;

using Text = Handle(TCollection_HAsciiString);

Text text_of(const std::string& text) { return new TCollection_HAsciiString(text.c_str()); }

Handle(Interface_HArray1OfHAsciiString) lines_of(const std::vector<std::string>& texts) {
  Handle(Interface_HArray1OfHAsciiString) lines =
      new Interface_HArray1OfHAsciiString(1, std::max<int>(1, static_cast<int>(texts.size())));
  if (texts.empty()) lines->SetValue(1, text_of(""));
  for (std::size_t i = 0; i < texts.size(); ++i)
    lines->SetValue(static_cast<int>(i) + 1, text_of(texts[i]));
  return lines;
}

/// No time: the same model gives the same bytes.
void fill_header(const Handle(StepData_StepModel) & model, const StepLabels& labels) {
  APIHeaderSection_MakeHeader header(model);
  if (!header.IsDone()) throw error::kernel_failure("the STEP file got no header");
  header.SetName(text_of(labels.file));
  header.SetTimeStamp(text_of("1970-01-01T00:00:00"));
  header.SetAuthor(lines_of({}));
  header.SetOrganization(lines_of({}));
  header.SetOriginatingSystem(text_of(labels.origin));
  header.SetAuthorisation(text_of(""));
  header.SetDescription(lines_of(labels.description));
}

bool has_pole(const TopoDS_Face& face) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
    if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) return true;
  return false;
}

/// Values strictly between two, none further than a span from the next.
std::vector<double> cuts(double first, double last) {
  std::vector<double> out;
  const int spans = static_cast<int>(std::ceil((last - first) / kSpans.most));
  for (int i = 1; i < spans; ++i) out.push_back(first + (last - first) * i / spans);
  return out;
}

/// The surface of a face on a surface of revolution whose meridian is an arc that ends on the axis,
/// as a lemon's does: as a B-spline surface of that arc and no more. Null for all other faces.
///
/// The translator would sweep the whole circle, of which readers take the wrong part where a face
/// ends in a pole. In short spans, because integrals take a fixed number of points in each.
Handle(Geom_Surface) swept_by_arc(const TopoDS_Face& face) {
  const auto swept = Handle(Geom_SurfaceOfRevolution)::DownCast(BRep_Tool::Surface(face));
  if (swept.IsNull() || swept->BasisCurve()->DynamicType() != STANDARD_TYPE(Geom_TrimmedCurve) ||
      !has_pole(face))
    return {};
  const Handle(Geom_BSplineSurface) exact = GeomConvert::SurfaceToBSplineSurface(swept);
  exact->SetUNotPeriodic();
  double u_min = 0, u_max = 0, v_min = 0, v_max = 0;
  exact->Bounds(u_min, u_max, v_min, v_max);
  for (const double u : cuts(u_min, u_max)) exact->InsertUKnot(u, 1, kSpans.same_knot);
  for (const double v : cuts(v_min, v_max)) exact->InsertVKnot(v, 1, kSpans.same_knot);
  return {exact};
}

/// Throws Error(KERNEL_FAILURE).
Handle(StepRepr_RepresentationItem)
    name_item(const Handle(Transfer_FinderProcess) & made, const TopoDS_Shape& shape,
              const char* what, const std::string& name) {
  Handle(StepRepr_RepresentationItem) item = STEPConstruct::FindEntity(made, shape);
  if (item.IsNull())
    throw error::kernel_failure("the STEP file lacks the " + std::string(what) + " " + name);
  item->SetName(text_of(name));
  return item;
}

/// Names the products: the translator would number them by their count in the process, so that the
/// bytes were not the same each time.
void name_products(const Handle(StepData_StepModel) & model, const std::string& name) {
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(StepBasic_Product) product = Handle(StepBasic_Product)::DownCast(model->Value(i));
    if (product.IsNull()) continue;
    product->SetId(text_of(name));
    product->SetName(text_of(name));
  }
}

std::string print(const Handle(StepData_StepModel) & model) {
  StepData_StepWriter writer(model);
  writer.FloatWriter().SetFormat("%#.16G");
  writer.SendModel(Handle(StepData_Protocol)::DownCast(model->Protocol()));
  std::ostringstream out;
  if (!writer.Print(out)) throw error::kernel_failure("the STEP file could not be printed");
  return tidy_exchange_text(std::move(out).str());
}

std::string write_solid(const TopoDS_Shape& solid, const WholeFaces& wholes, const Brep& brep,
                        const Skin& skin, const StepLabels& labels, const Run& run) {
  Interface_Static::SetCVal("write.step.unit", labels.unit.name);
  STEPControl_Writer writer;
  const Handle(StepData_StepModel) model = writer.Model(/*newone=*/true);
  // The translator divides lengths by write unit / local unit: kernel units become the model's.
  model->SetLocalLengthUnit(1);
  model->SetWriteLengthUnit(brep.scale);
  writer.SetTolerance(1e-7);
  with_progress(run, [&](const Message_ProgressRange& range) {
    if (writer.Transfer(solid, STEPControl_ManifoldSolidBrep, /*compgraph=*/true, range) !=
        IFSelect_RetDone) {
      run.poll();
      throw error::kernel_failure("the solid could not be translated to STEP");
    }
  });
  const Handle(Transfer_FinderProcess) made = writer.WS()->TransferWriter()->FinderProcess();
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  for (int f = 0; f < faces.Extent(); ++f) {
    const auto item = Handle(StepShape_FaceSurface)::DownCast(
        name_item(made, faces(f + 1), "face", skin.names[wholes[f]]));
    const Handle(Geom_Surface) swept = swept_by_arc(TopoDS::Face(faces(f + 1)));
    if (item.IsNull() || swept.IsNull()) continue;
    item->SetFaceGeometry(GeomToStep_MakeSurface(swept).Value());
    model->AddWithRefs(item->FaceGeometry());
  }
  name_item(made, solid, "solid", labels.solid);
  name_products(model, labels.solid);
  fill_header(model, labels);
  return print(model);
}

/// Null where faces cannot be joined.
TopoDS_Shape joined_solid(const Brep& brep, const Skin& skin, WholeFaces& wholes) {
  try {
    return skin_solid(brep, skin, /*join=*/true, wholes);
  } catch (const Error&) {
    return {};
  } catch (const Standard_Failure&) {
    return {};
  }
}

}  // namespace

std::string write_step(const Brep& brep, const Skin& skin, const StepLabels& labels,
                       const Run& run) {
  std::string out;
  with_step_translator([&] {
    WholeFaces wholes;
    TopoDS_Shape solid = joined_solid(brep, skin, wholes);
    if (solid.IsNull()) solid = skin_solid(brep, skin, /*join=*/false, wholes);
    run.poll();
    out = write_solid(solid, wholes, brep, skin, labels, run);
  });
  return out;
}

}  // namespace remeshd::kernel
