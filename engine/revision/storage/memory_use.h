#pragma once

#include <cstddef>
#include <vector>

#include "engine/revision/revision.h"

namespace remeshd {

/// A block of memory that revisions may share: it then has the same address and size for each.
struct MemoryBlock {
  const void* address;
  std::size_t bytes;
};

/// The blocks that hold a revision's mesh, its Delaunay mesh and what goes with them, each once.
std::vector<MemoryBlock> memory_blocks(const Revision& revision);

}  // namespace remeshd
