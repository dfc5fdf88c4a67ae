#include "engine/difference/compare.h"
#include "server/daemon.h"

namespace remeshd {
namespace {

ModelSummary summary_of(const FeatureModel& model, const Run& run) {
  const CellularModel cells = build_cells(model, run);
  return {.volume = cells.volume,
          .area = cells.area,
          .cells = static_cast<std::uint32_t>(cells.complex(run).cells.size()),
          .faces = static_cast<std::uint32_t>(cells.boundary.faces.size()),
          .edges = static_cast<std::uint32_t>(cells.boundary.edges.size()),
          .vertices = static_cast<std::uint32_t>(cells.boundary.vertices.size())};
}

}  // namespace

Engine production_engine() {
  return {.algorithm_version = 13,
          .evaluate = evaluate,
          .apply = apply,
          .summarise = summary_of,
          .make_revision = make_revision,
          .compare = compare,
          .serialise = serialise,
          .deserialise = deserialise,
          .feature_types = [] { return feature_types(); },
          .memory_blocks = memory_blocks};
}

}  // namespace remeshd
