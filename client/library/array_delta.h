// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/library/array_shape.h"
#include "remesh/v1/remesh.pb.h"

namespace remeshd::client {

/// The array that a delta makes of the base's array of the same name, to the bit.
///
/// Pre: `shape` is numeric. Throws CallError MESH_DAMAGED for a delta that does not come to `count`
/// rows, copies rows that the base has not, has too few or too many rows of its own, or counts
/// beyond what a number of the array can be.
std::string apply_delta(const remesh::v1::ArrayDelta& delta, const ArrayShape& shape,
                        std::uint32_t count, std::string_view base);

}  // namespace remeshd::client
