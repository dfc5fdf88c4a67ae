#include "server/session/mesh_options.h"

#include <cmath>

#include "server/session/session_error.h"

namespace remeshd {
namespace {

void check(const OptionsPatch& patch) {
  if (patch.nodes && patch.size)
    throw error::option_invalid("nodes", "and `size` exclude each other");
  if (patch.nodes && *patch.nodes < 20) throw error::option_invalid("nodes", "is less than 20");
  if (patch.size && !(std::isfinite(*patch.size) && *patch.size > 0))
    throw error::option_invalid("size", "is not a positive length");
  if (patch.iterations && *patch.iterations > 1000)
    throw error::option_invalid("iterations", "is more than 1000");
  if (patch.threshold && !(*patch.threshold >= 0 && *patch.threshold <= 0.8))
    throw error::option_invalid("threshold", "is not between 0 and 0.8");
}

/// What the patch leaves out is the base's, but for the density.
MeshOptions patched(const OptionsPatch& patch, const MeshOptions& base) {
  MeshOptions options;
  options.nodes = patch.nodes;
  options.size = patch.size;
  options.iterations = patch.iterations.value_or(base.iterations);
  options.seed = patch.seed.value_or(base.seed);
  options.inside = patch.inside.value_or(base.inside);
  options.start = patch.start.value_or(base.start);
  options.threshold = patch.threshold.value_or(base.threshold);
  options.clean_up = patch.clean_up.value_or(base.clean_up);
  return options;
}

}  // namespace

MeshOptions first_options(const OptionsPatch& patch) {
  constexpr std::uint32_t kDefaultNodes = 15000;
  check(patch);
  MeshOptions options = patched(patch, MeshOptions{});
  if (!options.nodes && !options.size) options.nodes = kDefaultNodes;
  return options;
}

MeshOptions edit_options(const OptionsPatch& patch, const MeshOptions& base) {
  check(patch);
  return patched(patch, base);  // both left out means the base's density
}

}  // namespace remeshd
