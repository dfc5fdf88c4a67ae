#pragma once

#include <cstddef>
#include <vector>

#include "engine/revision/revision.h"

namespace remeshd {

/// Memory that revisions may have in common; the same block has the same address and size.
struct MemoryBlock {
  const void* address;
  std::size_t bytes;
};

/// The blocks that a revision's mesh and its Delaunay mesh stand in, each once.
std::vector<MemoryBlock> memory_blocks(const Revision& revision);

}  // namespace remeshd
