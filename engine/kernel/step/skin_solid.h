#pragma once

#include <vector>

#include "engine/kernel/step/step_file.h"

class TopoDS_Shape;

namespace remeshd::kernel {

/// For each face of a solid, in the order in which TopExp::MapShapes has them, its number in
/// Skin::names.
using WholeFaces = std::vector<int>;

/// The solid that a skin closes, in kernel units; its shapes are copies. Where `join`, faces of one
/// face of the model are one, as are edges that no vertex of the skin parts.
///
/// Throws Error(KERNEL_FAILURE) where area or volume behind a joined face are not the sums of its
/// parts'.
TopoDS_Shape skin_solid(const Brep& brep, const Skin& skin, bool join, WholeFaces& wholes);

}  // namespace remeshd::kernel
