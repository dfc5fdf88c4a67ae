#include "engine/remesh/density.h"

#include <cmath>

#include "engine/base/error.h"
#include "engine/nodes/density.h"
#include "engine/remesh/node_budget.h"
#include "engine/remesh/node_limit.h"
#include "engine/sizing/size_rules.h"

namespace remeshd {
namespace {

constexpr std::uint32_t kDefaultNodes = 15000;
constexpr std::uint32_t kMinNodes = 20;

}  // namespace

Density resolve_density(const Revision& parent, const MeshOptions& options,
                        const FeatureModel& model, const CellularModel& cells, const Run& run) {
  if (options.nodes && options.size)
    throw error::options_invalid("nodes", "give a number of nodes or an edge length, not both");
  if (options.nodes && *options.nodes < kMinNodes)
    throw error::options_invalid("nodes", "at least 20 nodes have to be asked for");
  if (options.size && !(std::isfinite(*options.size) && *options.size > 0))
    throw error::options_invalid("size", "the edge length has to be a positive number");
  const double volume = cells.volume, area = cells.area;
  const bool first = parent.output.mesh.tets.empty();
  Density density;
  double edge_length = 0;
  if (options.size) {
    edge_length = *options.size;
    density.nodes_per_volume = expected_nodes(volume, area, edge_length) / volume;
  } else if (first || options.nodes) {
    const std::uint32_t nodes = options.nodes.value_or(kDefaultNodes);
    edge_length = edge_length_for(volume, area, nodes);
    density.nodes_per_volume = nodes / volume;
    if (first) density.count = nodes;
  } else {
    edge_length = parent.edge_length;
    // What the edge length says, not what the parent has: small errors of many edits would add
    // up.
    density.nodes_per_volume = expected_nodes(volume, area, edge_length) / volume;
    density.inherited = true;
  }
  edge_length = std::fmin(edge_length, parent.edge_length);
  check_node_limit(parent, extent_of(cells), edge_length, options, run);
  density.sizes = size_field(cells.boundary, options.sizing, edge_length);
  if (!density.sizes.even() && density.count)
    density.sizes = sizes_for_budget(*density.count, density.sizes, options, model, cells, run);
  return density;
}

SizeField sizes_of(const Revision& revision) {
  return size_field(revision.cells.boundary, revision.options.sizing, revision.edge_length);
}

}  // namespace remeshd
