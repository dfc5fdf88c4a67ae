#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace remeshd::bench {

/// The paper's time of a remesh over that of a regular run (Table 3, last column), for its sizes of
/// 15,000 and 30,000 nodes and 5 and 10 iterations.
std::optional<double> paper_ratio(std::string_view edit, std::uint32_t nodes,
                                  std::uint32_t iterations);

}  // namespace remeshd::bench
