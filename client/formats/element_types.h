// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace remeshd::client {

// Numbers of the formats for the element types of facets and tets.
inline constexpr std::int32_t kGmshTriangle = 2;
inline constexpr std::int32_t kGmshTetrahedron = 4;
inline constexpr std::int32_t kGmshTriangle6 = 9;
inline constexpr std::int32_t kGmshTetrahedron10 = 11;
inline constexpr std::uint8_t kVtkTriangle = 5;
inline constexpr std::uint8_t kVtkTetra = 10;
inline constexpr std::uint8_t kVtkQuadraticTriangle = 22;
inline constexpr std::uint8_t kVtkQuadraticTetra = 24;

}  // namespace remeshd::client
