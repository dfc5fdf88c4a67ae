#pragma once

#include <functional>

#include "engine/base/vec.h"

namespace remeshd {

/// Whether a point lies in the model (Sect. 3.1: "an efficient point location test is needed"), by
/// membership in the features or by the control mesh; or, in some uses, in a part of the model.
using InsideTest = std::function<bool(const Vec3&)>;

}  // namespace remeshd
