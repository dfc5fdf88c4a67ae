#include "engine/optimise/node_lengths.h"

#include "engine/base/parallel.h"

namespace remeshd {

void NodeLengths::follow(const std::vector<Vec3>& positions, const Run& run) {
  if (even()) return;
  known_.resize(positions.size());
  in_blocks(known_.size(), kFairBlock, run, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
      if (known_[n].length < 0 || !(known_[n].at == positions[n]))
        known_[n] = {positions[n], sizes_(positions[n])};
  });
}

}  // namespace remeshd
