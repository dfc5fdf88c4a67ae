#pragma once

#include "engine/kernel/brep.h"
#include "engine/model/feature_model.h"

namespace remeshd {

/// The solid of a feature in its own frame, its faces labelled with the names of
/// client/docs/model.md.
///
/// Throws Error(KERNEL_FAILURE) where the CAD kernel cannot build it.
kernel::Brep feature_brep(const Feature& feature, double scale);

}  // namespace remeshd
