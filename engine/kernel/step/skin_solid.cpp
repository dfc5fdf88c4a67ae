#include "engine/kernel/step/skin_solid.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepTools_History.hxx>
#include <BRep_Builder.hxx>
#include <ShapeCustom.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/error.h"
#include "engine/base/tolerance.h"
#include "engine/base/union_find.h"
#include "engine/kernel/brep_shapes.h"

namespace remeshd::kernel {
namespace {

/// The faces of one closed shell, oriented with the material behind them.
struct ShellFaces {
  std::vector<TopoDS_Face> faces;
  std::vector<int> wholes;  ///< of each face: its number in Skin::names
  double volume = 0;        ///< swept from the reference point; below 0 where the shell is a void
};

/// The shell that each face of a skin is in: shells are connected by edges.
std::vector<int> shells_of(const Brep& brep, const Skin& skin) {
  UnionFind joined(skin.faces.size());
  std::vector<int> at_edge(brep.edges.size(), -1);
  for (std::size_t i = 0; i < skin.faces.size(); ++i)
    for (const int e : brep.faces[skin.faces[i].face].edges) {
      if (at_edge[e] >= 0) joined.join(at_edge[e], static_cast<int>(i));
      at_edge[e] = static_cast<int>(i);
    }
  std::vector<int> shells(skin.faces.size());
  for (std::size_t i = 0; i < shells.size(); ++i) shells[i] = joined.find(static_cast<int>(i));
  return shells;
}

/// A copy of the faces of a skin, so that nothing here changes shapes that threads share.
class Copy {
 public:
  Copy(const Brep& brep, const Skin& skin) : brep_(brep) {
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    for (const SkinFace& part : skin.faces)
      builder.Add(all, shape_of(brep, Element::Face, part.face));
    copy_.Perform(all, /*copyGeom=*/true, /*copyMesh=*/false);
  }
  [[nodiscard]] TopoDS_Shape of(Element kind, int index) const {
    return copy_.ModifiedShape(shape_of(brep_, kind, index));
  }
  [[nodiscard]] TopoDS_Face face(const SkinFace& part) const {
    const TopoDS_Shape forward = of(Element::Face, part.face).Oriented(TopAbs_FORWARD);
    return TopoDS::Face(part.material_behind ? forward : forward.Reversed());
  }

 private:
  const Brep& brep_;
  mutable BRepBuilderAPI_Copy copy_;
};

std::vector<ShellFaces> part_shells(const Brep& brep, const Skin& skin, const Copy& copy) {
  const std::vector<int> shell_of = shells_of(brep, skin);
  std::map<int, ShellFaces> shells;
  for (std::size_t i = 0; i < skin.faces.size(); ++i) {
    const SkinFace& part = skin.faces[i];
    ShellFaces& shell = shells[shell_of[i]];
    shell.faces.push_back(copy.face(part));
    shell.wholes.push_back(part.whole);
    const double swept = brep.faces[part.face].swept_volume;
    shell.volume += part.material_behind ? swept : -swept;
  }
  std::vector<ShellFaces> out;
  for (auto& [number, shell] : shells) out.push_back(std::move(shell));
  // The outer shell comes first, then the voids.
  std::ranges::stable_partition(out, [](const ShellFaces& shell) { return shell.volume > 0; });
  return out;
}

TopoDS_Solid solid_of(const std::vector<ShellFaces>& shells) {
  BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  for (const ShellFaces& faces : shells) {
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (const TopoDS_Face& face : faces.faces) builder.Add(shell, face);
    shell.Closed(true);
    builder.Add(solid, shell);
  }
  solid.Closed(true);
  return solid;
}

/// The shells of the joined solid: each joined face where the first of its parts was, because the
/// kernel's own order is that of addresses.
std::vector<ShellFaces> joined_shells(const std::vector<ShellFaces>& parts,
                                      ShapeUpgrade_UnifySameDomain& unify) {
  TopTools_IndexedMapOfShape result;
  TopExp::MapShapes(unify.Shape(), TopAbs_FACE, result);
  std::vector<ShellFaces> shells;
  int used = 0;
  for (const ShellFaces& shell : parts) {
    ShellFaces joined;
    TopTools_MapOfShape seen;
    for (std::size_t i = 0; i < shell.faces.size(); ++i) {
      const TopTools_ListOfShape& images = unify.History()->Modified(shell.faces[i]);
      if (images.Extent() > 1) throw error::kernel_failure("a face fell apart as it was joined");
      const TopoDS_Shape& image = images.IsEmpty() ? shell.faces[i] : images.First();
      if (!seen.Add(image)) continue;
      const int at = result.FindIndex(image);
      if (at == 0) throw error::kernel_failure("a face got lost as it was joined");
      joined.faces.push_back(TopoDS::Face(result(at)));
      joined.wholes.push_back(shell.wholes[i]);
    }
    used += static_cast<int>(joined.faces.size());
    shells.push_back(std::move(joined));
  }
  if (used != result.Extent()) throw error::kernel_failure("a joined face comes from nothing");
  return shells;
}

/// Of a face of the model: area and swept volume, kernel units.
struct Measures {
  double area = 0, volume = 0;
};

/// Throws Error(KERNEL_FAILURE) where a joined face has not the area and swept volume of its parts.
void check_measures(const Brep& brep, const Skin& skin, const std::vector<ShellFaces>& shells) {
  std::vector<Measures> parts(skin.names.size()), joined(skin.names.size());
  const double l = brep.scale;
  for (const SkinFace& part : skin.faces) {
    const BrepFace& face = brep.faces[part.face];
    parts[part.whole].area += l * l * face.area;
    parts[part.whole].volume +=
        l * l * l * (part.material_behind ? face.swept_volume : -face.swept_volume);
  }
  const Vec3 reference = l * brep.reference;
  double size = 0;
  for (const ShellFaces& shell : shells)
    for (std::size_t i = 0; i < shell.faces.size(); ++i) {
      const TopoDS_Face& face = shell.faces[i];
      const FaceMoments moments =
          moments_of(TopoDS::Face(face.Oriented(TopAbs_FORWARD)), reference);
      Measures& whole = joined[shell.wholes[i]];
      whole.area += moments.area;
      whole.volume +=
          face.Orientation() == TopAbs_FORWARD ? moments.swept_volume : -moments.swept_volume;
      size = std::max(size, distance(moments.centroid, reference));
    }
  for (std::size_t w = 0; w < parts.size(); ++w)
    if (std::fabs(joined[w].area - parts[w].area) > tolerance::kSameMeasure * parts[w].area ||
        std::fabs(joined[w].volume - parts[w].volume) >
            tolerance::kSameMeasure * parts[w].area * size)
      throw error::kernel_failure("the face " + skin.names[w] + " is not as it was when joined");
}

}  // namespace

TopoDS_Shape skin_solid(const Brep& brep, const Skin& skin, bool join, WholeFaces& wholes) {
  const Copy copy(brep, skin);
  std::vector<ShellFaces> shells = part_shells(brep, skin, copy);
  TopoDS_Solid solid = solid_of(shells);
  if (join) {
    TopTools_MapOfShape kept;
    for (const int e : skin.edges) kept.Add(copy.of(Element::Edge, e));
    for (const int v : skin.vertices) kept.Add(copy.of(Element::Vertex, v));
    ShapeUpgrade_UnifySameDomain unify(solid, /*UnifyEdges=*/true, /*UnifyFaces=*/true,
                                       /*ConcatBSplines=*/false);
    unify.KeepShapes(kept);
    unify.Build();
    shells = joined_shells(shells, unify);
    check_measures(brep, skin, shells);
    solid = solid_of(shells);
  }
  wholes.clear();
  for (const ShellFaces& shell : shells)
    wholes.insert(wholes.end(), shell.wholes.begin(), shell.wholes.end());
  // STEP has no surfaces of left-handed frames. The translator would turn them too, but not tell
  // which face became which.
  return ShapeCustom::DirectFaces(solid);
}

}  // namespace remeshd::kernel
