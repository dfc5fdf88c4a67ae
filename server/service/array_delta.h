#pragma once

#include <string_view>

#include "remesh/v1/mesh.pb.h"
#include "server/session/mesh_arrays.h"

namespace remeshd {

/// What makes an array of the base's array of the same name, as ArrayDelta in mesh.proto says. Runs
/// of rows are copied from where they were in the base, or from wherever they are found there;
/// numbers that repeat or count up are told as such. A run is only told where it takes fewer bytes
/// than its rows.
///
/// Pre: `array` is one of numbers; `bytes` and `base` are whole rows of it.
remesh::v1::ArrayDelta delta_of(const MeshArray& array, std::string_view bytes,
                                std::string_view base);

}  // namespace remeshd
