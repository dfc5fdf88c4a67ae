// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "remesh/v1/remesh.pb.h"

namespace remeshd::client {

/// What a row of an array consists of.
struct ArrayShape {
  remesh::v1::ArrayType type = remesh::v1::ARRAY_TYPE_UNSPECIFIED;
  std::uint32_t components = 0;

  friend bool operator==(const ArrayShape&, const ArrayShape&) = default;
};

/// Bytes of one number; 0 for text and types that are not known.
constexpr std::size_t number_bytes(remesh::v1::ArrayType type) {
  switch (type) {
    case remesh::v1::ARRAY_TYPE_F64:
    case remesh::v1::ARRAY_TYPE_U64:
      return 8;
    case remesh::v1::ARRAY_TYPE_I32:
      return 4;
    case remesh::v1::ARRAY_TYPE_U8:
      return 1;
    default:
      return 0;
  }
}

/// Bytes of one row; 0 for text, whose rows differ.
constexpr std::size_t row_bytes(const ArrayShape& shape) {
  return number_bytes(shape.type) * shape.components;
}

}  // namespace remeshd::client
