#pragma once

#include <cstdint>
#include <string>

namespace remeshd::bench {

/// Runs one case in this process and prints what the Report says, a line a mesh: the original, the
/// remesh, and a regular run of the modified model with the remesh's node count.
void run_one_case(const std::string& edit, std::uint32_t nodes, std::uint32_t iterations,
                  std::uint64_t seed, int repeats);

}  // namespace remeshd::bench
