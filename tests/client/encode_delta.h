#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "remesh/v1/remesh.pb.h"

namespace remeshd::client {

/// A delta that makes `bytes` of `base`, as a daemon may send it: runs that are the longest at each
/// row, of the base's rows where they were, of one row again and again, or of numbers counted up.
inline remesh::v1::ArrayDelta encode_delta(std::string_view bytes, std::string_view base,
                                           std::size_t row, bool counts_up) {
  using remesh::v1::ArrayDelta;
  const auto at = [row](std::string_view array, std::size_t k) {
    return array.substr(k * row, row);
  };
  const auto number = [&](std::size_t k) {
    std::int64_t wide = 0;
    if (row == 4) {
      std::int32_t narrow = 0;
      std::memcpy(&narrow, bytes.data() + k * row, row);
      wide = narrow;
    } else {
      std::memcpy(&wide, bytes.data() + k * row, row);
    }
    return wide;
  };
  const std::size_t rows = bytes.size() / row;
  ArrayDelta delta;
  const auto add = [&](ArrayDelta::Kind kind, std::size_t count, std::int64_t start) {
    const int last = delta.kinds_size() - 1;
    if (kind == ArrayDelta::KIND_ROWS && last >= 0 && delta.kinds(last) == kind) {
      delta.set_counts(last, delta.counts(last) + static_cast<std::uint32_t>(count));
      return;
    }
    delta.add_kinds(kind);
    delta.add_counts(static_cast<std::uint32_t>(count));
    delta.add_starts(start);
  };
  for (std::size_t k = 0; k < rows;) {
    std::size_t same = 0;
    while (k + same < rows && (k + same + 1) * row <= base.size() &&
           at(bytes, k + same) == at(base, k + same))
      ++same;
    std::size_t again = 1;
    while (k + again < rows && at(bytes, k + again) == at(bytes, k)) ++again;
    std::size_t up = 1;
    while (counts_up && k + up < rows &&
           number(k + up) == number(k) + static_cast<std::int64_t>(up))
      ++up;
    if (same >= again && same >= up) {
      add(ArrayDelta::KIND_COPY, same, 0);
      k += same;
    } else if (up >= again && up > 1) {
      add(ArrayDelta::KIND_COUNT, up, number(k) - static_cast<std::int64_t>(k));
      k += up;
    } else {
      delta.mutable_rows()->append(at(bytes, k));
      add(again > 1 ? ArrayDelta::KIND_REPEAT : ArrayDelta::KIND_ROWS, again, 0);
      k += again;
    }
  }
  return delta;
}

}  // namespace remeshd::client
