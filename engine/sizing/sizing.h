#pragma once

#include <cstdint>
#include <optional>

namespace remeshd {

/// Where a mesh is finer than its base size. Each rule lessens the edge length where it asks for
/// less.
struct Sizing {
  bool even = true;                     ///< one edge length everywhere: no rule holds
  std::uint32_t edges_per_circle = 12;  ///< on a whole circle of any radius; 0: no such rule
  std::uint32_t layers = 1;             ///< edges across walls and gaps; 0: no such rule
  std::optional<double> min_size;       ///< no rule goes below; nothing: a tenth of the base size
  double growth = 1.3;                  ///< of edge lengths from one tet to the next, > 1
  friend bool operator==(const Sizing&, const Sizing&) = default;
};

}  // namespace remeshd
