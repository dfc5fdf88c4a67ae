#pragma once

#include <string_view>

#include "remesh/v1/mesh.pb.h"
#include "server/session/mesh_arrays.h"

namespace remeshd {

/// The difference by which the base's array of the same name becomes this one, as ArrayDelta in
/// mesh.proto says. Runs of rows are copied from where they were in the base, or from wherever they
/// are found there; numbers that repeat or count up are encoded as such. A run is used only where
/// it takes fewer bytes than its rows.
///
/// Pre: `array` is numeric; `bytes`, its data, and `base`, those of the base's, are whole rows.
remesh::v1::ArrayDelta delta_of(const MeshArray& array, std::string_view bytes,
                                std::string_view base);

}  // namespace remeshd
