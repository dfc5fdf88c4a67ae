// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace remeshd::client {

// What the formats call a facet and a tet.
inline constexpr std::int32_t kGmshTriangle = 2;
inline constexpr std::int32_t kGmshTetrahedron = 4;
inline constexpr std::uint8_t kVtkTetra = 10;

}  // namespace remeshd::client
