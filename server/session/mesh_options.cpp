#include "server/session/mesh_options.h"

#include <cmath>
#include <string>

#include "server/session/session_error.h"

namespace remeshd {
namespace {

constexpr double kMostHold = 10;  // x edge length

void check(const SizingPatch& patch) {
  if (patch.edges_per_circle && *patch.edges_per_circle != 0 &&
      (*patch.edges_per_circle < 3 || *patch.edges_per_circle > 360))
    throw error::option_invalid("sizing.edges_per_circle", "is neither 0 nor between 3 and 360");
  if (patch.layers && *patch.layers > 16)
    throw error::option_invalid("sizing.layers", "is more than 16");
  if (patch.min_size && !(std::isfinite(*patch.min_size) && *patch.min_size > 0))
    throw error::option_invalid("sizing.min_size", "is not a positive length");
  if (patch.growth && !(*patch.growth > 1 && *patch.growth <= 2))
    throw error::option_invalid("sizing.growth", "is not above 1 and at most 2");
}

void check(const OptionsPatch& patch) {
  if (patch.nodes && patch.size)
    throw error::option_invalid("nodes", "and `size` exclude each other");
  if (patch.nodes && *patch.nodes < kMinNodes)
    throw error::option_invalid("nodes", "is less than " + std::to_string(kMinNodes));
  if (patch.size && !(std::isfinite(*patch.size) && *patch.size > 0))
    throw error::option_invalid("size", "is not a positive length");
  if (patch.iterations && *patch.iterations > 1000)
    throw error::option_invalid("iterations", "is more than 1000");
  if (patch.threshold && !(*patch.threshold >= 0 && *patch.threshold <= 0.8))
    throw error::option_invalid("threshold", "is not between 0 and 0.8");
  if (patch.order && *patch.order != 1 && *patch.order != 2)
    throw error::option_invalid("order", "is neither 1 nor 2");
  if (patch.hold && !(*patch.hold >= 0 && *patch.hold <= kMostHold))
    throw error::option_invalid("hold", "is not between 0 and 10");
  check(patch.sizing);
}

/// For an even mesh all rules are reset: it has none to pass on to its edits.
Sizing patched(const SizingPatch& patch, const Sizing& base) {
  const bool rules = patch.edges_per_circle || patch.layers || patch.min_size || patch.growth;
  if (patch.even.value_or(base.even && !rules)) return {.even = true};
  return {.even = false,
          .edges_per_circle = patch.edges_per_circle.value_or(base.edges_per_circle),
          .layers = patch.layers.value_or(base.layers),
          .min_size = patch.min_size ? patch.min_size : base.min_size,
          .growth = patch.growth.value_or(base.growth)};
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
  options.order = patch.order.value_or(base.order);
  options.hold = patch.hold.value_or(base.hold);
  options.sizing = patched(patch.sizing, base.sizing);
  return options;
}

}  // namespace

MeshOptions first_options(const OptionsPatch& patch) {
  check(patch);
  MeshOptions options = patched(patch, {.sizing = {.even = false}});
  if (!options.nodes && !options.size) options.nodes = kDefaultNodes;
  return options;
}

MeshOptions edit_options(const OptionsPatch& patch, const MeshOptions& base) {
  check(patch);
  return patched(patch, base);  // no target means the base's density
}

}  // namespace remeshd
