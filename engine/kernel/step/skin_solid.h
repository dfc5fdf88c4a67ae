#pragma once

#include <vector>

#include "engine/kernel/step/step_file.h"

class TopoDS_Shape;

namespace remeshd::kernel {

/// For each face of a solid, in the order in which TopExp::MapShapes has them, its number in
/// Skin::names.
using WholeFaces = std::vector<int>;

/// The solid that a skin bounds, in kernel units; its shapes are copies. With `join`, the faces
/// that are parts of one face of the model are joined, and so are edges unless a vertex of the skin
/// is between them. Fills in `wholes`.
///
/// Throws Error(KERNEL_FAILURE) where area or swept volume of a joined face are not the sums of
/// those of its parts.
TopoDS_Shape skin_solid(const Brep& brep, const Skin& skin, bool join, WholeFaces& wholes);

}  // namespace remeshd::kernel
