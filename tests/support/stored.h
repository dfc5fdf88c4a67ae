#pragma once

#include <string>
#include <utility>

#include "engine/revision/storage/stored_revision.h"

namespace remeshd::test {

/// All that a revision is stored as, name after name.
inline std::string stored_bytes(const Revision& revision) {
  std::string bytes;
  for (const StoredArray& array : image_of(revision).arrays) bytes += array.name + array.flat();
  return bytes;
}

/// An image that does not lie in the revision's memory.
inline StoredArrays copied(const StoredArrays& image) {
  StoredArrays copy = image;
  for (StoredArray& array : copy.arrays) {
    array.own(array.flat());
  }
  return copy;
}

inline Revision stored_and_loaded(const Revision& revision, const Revision* alike = nullptr) {
  return revision_of(copied(image_of(revision)), alike, {});
}

}  // namespace remeshd::test
