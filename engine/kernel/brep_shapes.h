#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/kernel/brep.h"

class TopoDS_Shape;

namespace remeshd::kernel {

/// Reads every element of a CAD shape, triangulates it, and orders all of it by geometry.
///
/// `labels` names faces of the shape. The shape is the Brep's own from then on.
/// Throws Error(KernelFailure) where the shape has no solid, a face has no triangulation, or
/// anything of that kind.
Brep describe(const TopoDS_Shape& shape, double scale,
              const std::vector<std::pair<TopoDS_Shape, std::string>>& labels);

enum class Element { Cell, Face, Edge, Vertex };

/// The CAD shape behind an element of a Brep.
const TopoDS_Shape& shape_of(const Brep& brep, Element kind, int index);
/// The element with this CAD shape, whatever its orientation; -1 if there is none.
int index_of(const Brep& brep, Element kind, const TopoDS_Shape& shape);

}  // namespace remeshd::kernel
