#include <BOPAlgo_Alerts.hxx>
#include <BOPAlgo_Builder.hxx>
#include <BOPAlgo_PaveFiller.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <Message_Alert.hxx>
#include <Message_ProgressRange.hxx>
#include <Message_Report.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_AlertWithShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "engine/base/error.h"
#include "engine/kernel/brep.h"
#include "engine/kernel/brep_shapes.h"
#include "engine/mesh/grouping.h"

namespace remeshd::kernel {
namespace {

/// A part as its own copy in kernel units: the fuse may change tolerances of what it is given, and
/// Breps are shared between threads.
class PlacedPart {
 public:
  PlacedPart(const Part& part, double scale) : brep_(*part.brep) {
    TopoDS_Compound cells;
    BRep_Builder builder;
    builder.MakeCompound(cells);
    for (const int cell : part.cells) builder.Add(cells, shape_of(brep_, Element::Cell, cell));
    const auto& m = part.where.m;
    gp_Trsf place;
    place.SetValues(m[0], m[1], m[2], m[3] * scale, m[4], m[5], m[6], m[7] * scale, m[8], m[9],
                    m[10], m[11] * scale);
    if (brep_.scale != scale) {
      gp_Trsf rescale;
      rescale.SetScaleFactor(scale / brep_.scale);
      place.Multiply(rescale);
    }
    copy_.emplace(cells, place, /*theCopyGeom=*/true);

    std::set<int> faces, edges, vertices;
    for (const int c : part.cells)
      for (const int f : brep_.cells[c].faces) {
        faces.insert(f);
        for (const int e : brep_.faces[f].edges) {
          edges.insert(e);
          vertices.insert(brep_.edges[e].vertices.begin(), brep_.edges[e].vertices.end());
        }
      }
    elements_[0].assign(part.cells.begin(), part.cells.end());
    elements_[1].assign(faces.begin(), faces.end());
    elements_[2].assign(edges.begin(), edges.end());
    elements_[3].assign(vertices.begin(), vertices.end());
  }

  [[nodiscard]] TopoDS_Shape shape() const { return copy_->Shape(); }
  [[nodiscard]] const std::vector<int>& elements(Element kind) const {
    return elements_[static_cast<int>(kind)];
  }
  [[nodiscard]] TopoDS_Shape copy_of(Element kind, int index) const {
    return copy_->ModifiedShape(shape_of(brep_, kind, index));
  }

 private:
  const Brep& brep_;
  mutable std::optional<BRepBuilderAPI_Transform> copy_;
  std::array<std::vector<int>, 4> elements_;
};

/// Throws Error(KERNEL_FAILURE) where the algorithm raised alerts, with the place of the first one
/// that has a shape with geometry.
///
/// One warning is let pass: that the kernel could not tell whether a split face is oriented as its
/// original is. Natures here come from the cells' own orientation, and samples and volumes check
/// those.
void refuse_alerts(const BOPAlgo_Options& algorithm, std::string what, double scale,
                   const Run& run) {
  run.poll();
  std::vector<std::string> keys;
  std::optional<Vec3> place;
  for (const Message_Gravity gravity : {Message_Fail, Message_Alarm, Message_Warning})
    for (const Handle(Message_Alert) & alert : algorithm.GetReport()->GetAlerts(gravity)) {
      if (alert->IsKind(STANDARD_TYPE(BOPAlgo_AlertUnableToOrientTheShape))) continue;
      const std::string key = alert->GetMessageKey();
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
      const auto with_shape = Handle(TopoDS_AlertWithShape)::DownCast(alert);
      if (!place && !with_shape.IsNull()) place = point_on(with_shape->GetShape());
    }
  if (keys.empty()) return;
  for (const std::string& key : keys) what += ' ' + key;
  throw error::kernel_failure(what, in_model_units(place, scale));
}

/// By element of the result, of which there are `count` of this kind: the elements of the parts
/// that it comes from, by the builder's history.
std::vector<std::vector<Source>> trace(const std::vector<PlacedPart>& parts,
                                       BOPAlgo_Builder& builder, const Brep& brep, double scale,
                                       Element kind, std::size_t count) {
  std::vector<std::vector<Source>> sources(count);
  for (int p = 0; p < static_cast<int>(parts.size()); ++p)
    for (const int i : parts[p].elements(kind)) {
      const TopoDS_Shape shape = parts[p].copy_of(kind, i);
      const auto add = [&](const TopoDS_Shape& image) {
        const int at = index_of(brep, kind, image);
        if (at < 0)
          throw error::kernel_failure("the history names what the result lacks",
                                      in_model_units(point_on(image), scale));
        sources[at].push_back({p, i});
      };
      // An empty list means unchanged.
      if (parts.size() > 1 && !builder.Modified(shape).IsEmpty()) {
        for (const TopoDS_Shape& image : builder.Modified(shape)) add(image);
      } else {
        add(shape);
      }
    }
  for (auto& list : sources) sort_unique(list);
  return sources;
}

/// Throws Error(KERNEL_FAILURE) where an element of the result comes from no part.
void require_owners(const Brep& brep, double scale, Element kind,
                    const std::vector<std::vector<Source>>& sources, const char* what) {
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (sources[i].empty()) {
      const TopoDS_Shape& shape = shape_of(brep, kind, static_cast<int>(i));
      throw error::kernel_failure(what, in_model_units(point_on(shape), scale));
    }
}

Fusion fuse_parts(const std::vector<PlacedPart>& parts, double scale, const Run& run,
                  const std::optional<Vec3>& reference) {
  BOPAlgo_PaveFiller filler;
  BOPAlgo_Builder builder;
  TopoDS_Shape result;
  if (parts.size() > 1) {  // the fuse refuses a single argument
    TopTools_ListOfShape arguments;
    for (const PlacedPart& part : parts) arguments.Append(part.shape());
    filler.SetArguments(arguments);
    with_progress(run, [&](const Message_ProgressRange& range) { filler.Perform(range); });
    refuse_alerts(filler, "intersecting the features:", scale, run);
    builder.SetArguments(arguments);
    with_progress(
        run, [&](const Message_ProgressRange& range) { builder.PerformWithFiller(filler, range); });
    refuse_alerts(builder, "building the cells:", scale, run);
    result = builder.Shape();
  } else {
    result = parts.front().shape();
  }

  Fusion fusion;
  const Brep& brep = fusion.brep = describe(result, scale, run, reference);
  const auto sources_of = [&](Element kind, std::size_t count) {
    return trace(parts, builder, brep, scale, kind, count);
  };
  fusion.cells = sources_of(Element::Cell, brep.cells.size());
  fusion.faces = sources_of(Element::Face, brep.faces.size());
  fusion.edges = sources_of(Element::Edge, brep.edges.size());
  fusion.vertices = sources_of(Element::Vertex, brep.vertices.size());
  require_owners(brep, scale, Element::Cell, fusion.cells, "a cell of the result has no owner");
  require_owners(brep, scale, Element::Face, fusion.faces, "a face of the result has no owner");
  return fusion;
}

}  // namespace

Fusion general_fuse(std::span<const Part> parts, const Run& run,
                    const std::optional<Vec3>& reference) {
  try {
    const double scale = parts.front().brep->scale;
    std::vector<PlacedPart> placed;
    placed.reserve(parts.size());
    for (const Part& part : parts) placed.emplace_back(part, scale);
    return fuse_parts(placed, scale, run, reference);
  } catch (const Standard_Failure& failure) {
    throw error::kernel_failure(failure.GetMessageString());
  }
}

}  // namespace remeshd::kernel
