#include "engine/base/stored_array.h"

#include <algorithm>

namespace remeshd {

void StoredArray::own(std::string bytes) {
  owned = std::make_shared<const std::string>(std::move(bytes));
  pieces.clear();
  if (piece_bytes == 0) {
    // About 4 KB, of whole elements.
    const std::size_t element = bytes_of(type) * components;
    piece_bytes = std::max<std::size_t>(1, 4096 / element) * element;
  }
  for (std::size_t at = 0; at < owned->size(); at += piece_bytes)
    pieces.push_back(std::string_view(*owned).substr(at, piece_bytes));
}

std::size_t StoredArray::size() const {
  return pieces.empty() ? 0 : (pieces.size() - 1) * piece_bytes + pieces.back().size();
}

std::string StoredArray::flat() const {
  std::string bytes;
  bytes.reserve(size());
  for (const std::string_view piece : pieces) bytes += piece;
  return bytes;
}

const StoredArray* StoredArrays::find(std::string_view name) const {
  const auto found = std::find_if(arrays.begin(), arrays.end(),
                                  [&](const StoredArray& array) { return array.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

std::size_t StoredArrays::size() const {
  std::size_t bytes = 0;
  for (const StoredArray& array : arrays) bytes += array.size();
  return bytes;
}

}  // namespace remeshd
