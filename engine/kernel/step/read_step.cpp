#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_AdvancedFace.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <sstream>

#include "engine/base/error.h"
#include "engine/kernel/brep_shapes.h"
#include "engine/kernel/step/step_file.h"
#include "engine/kernel/step/step_session.h"

namespace remeshd::kernel {
namespace {

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found.Extent();
}

int count_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, edges);
  int out = 0;
  for (int e = 1; e <= edges.Extent(); ++e) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.FindKey(e));
    if (BRep_Tool::Degenerated(edge)) continue;
    if (edges(e).Extent() == 1 && BRep_Tool::IsClosed(edge, TopoDS::Face(edges(e).First())))
      continue;  // a seam
    ++out;
  }
  return out;
}

/// Fills in area, volume and box, in the file's unit.
void measure(const TopoDS_Shape& shape, double scale, StepContent& out) {
  const double l = 1 / scale;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current().Oriented(TopAbs_FORWARD));
    const FaceMoments moments = moments_of(face, Vec3{});
    const bool forward = it.Current().Orientation() == TopAbs_FORWARD;
    out.area += l * l * moments.area;
    out.volume += l * l * l * (forward ? moments.swept_volume : -moments.swept_volume);
  }
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, /*useTriangulation=*/false, /*useShapeTolerance=*/false);
  if (!box.IsVoid()) {
    out.box.add(l * vec(box.CornerMin()));
    out.box.add(l * vec(box.CornerMax()));
  }
}

void read_names(const Handle(StepData_StepModel) & model,
                const Handle(Transfer_TransientProcess) & made, double scale, StepContent& out) {
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    if (const auto solid = Handle(StepShape_ManifoldSolidBrep)::DownCast(entity); !solid.IsNull())
      out.solid_names.emplace_back(solid->Name()->ToCString());
    const auto face = Handle(StepShape_AdvancedFace)::DownCast(entity);
    if (face.IsNull()) continue;
    StepFace& named = out.faces.emplace_back();
    named.name = face->Name()->ToCString();
    const TopoDS_Shape shape = TransferBRep::ShapeResult(made, entity);
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      named.area += moments_of(TopoDS::Face(it.Current().Oriented(TopAbs_FORWARD)), {}).area /
                    (scale * scale);
  }
}

}  // namespace

StepContent read_step(const std::string& bytes, const LengthUnit& unit, double scale,
                      const Run& run) {
  StepContent out;
  with_step_translator([&] {
    STEPControl_Reader reader;
    std::istringstream in(bytes);
    if (reader.ReadStream("part.step", in) != IFSelect_RetDone)
      throw error::kernel_failure("the STEP file cannot be read");
    const Handle(StepData_StepModel) model = reader.StepModel();
    model->SetLocalLengthUnit(unit.millimetres / scale);
    with_progress(run, [&](const Message_ProgressRange& range) { reader.TransferRoots(range); });
    const TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull()) throw error::kernel_failure("the STEP file holds no shape");
    out.solids = count(shape, TopAbs_SOLID);
    out.shells = count(shape, TopAbs_SHELL);
    out.edges = count_edges(shape);
    measure(shape, scale, out);
    read_names(model, reader.WS()->TransferReader()->TransientProcess(), scale, out);
  });
  return out;
}

}  // namespace remeshd::kernel
