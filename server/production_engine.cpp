#include <algorithm>
#include <iterator>
#include <utility>

#include "engine/base/stopwatch.h"
#include "engine/delivery/lost_names.h"
#include "engine/delivery/unmeshed.h"
#include "engine/difference/compare.h"
#include "engine/kernel/tetgen.h"
#include "engine/motion/design_velocities.h"
#include "engine/remesh/density.h"
#include "engine/remesh/forecast.h"
#include "engine/remesh/node_limit.h"
#include "engine/remesh/remesh.h"
#include "engine/revision/storage/stored_revision.h"
#include "server/daemon.h"

namespace remeshd {
namespace {

/// The parent revision; a first mesh has no base (null), and the empty revision for its parent.
const Revision& parent(const Revision* base) { return base != nullptr ? *base : Revision::none(); }

ModelSummary summary_of(const Revision* base, const FeatureModel& model, const MeshOptions& options,
                        const Run& run) {
  const Stopwatch watch;
  const CellularModel cells = build_cells(model, run);
  check_groups(parent(base), model, cells.boundary, run);
  Density density = resolve_density(parent(base), options, model, cells, run);
  Forecast expected = forecast(density, model, cells, options, watch.total(), run);
  std::vector<Warning> warnings = names_to_be_lost(parent(base), model, cells.boundary, run);
  std::ranges::move(density.warnings, std::back_inserter(warnings));
  return {.volume = cells.volume,
          .area = cells.area,
          .cells = static_cast<std::uint32_t>(cells.complex(run).cells.size()),
          .faces = static_cast<std::uint32_t>(cells.boundary.faces.size()),
          .edges = static_cast<std::uint32_t>(cells.boundary.edges.size()),
          .vertices = static_cast<std::uint32_t>(cells.boundary.vertices.size()),
          .warnings = std::move(warnings),
          .forecast = std::move(expected)};
}

std::vector<NodalVelocities> velocities_of(const Revision& revision,
                                           const std::vector<std::string>& parameters,
                                           const Run& run) {
  const DesignVelocities all(revision, run);
  std::vector<NodalVelocities> out;
  for (const std::string& parameter : parameters) out.push_back(all.of(parameter, run));
  return out;
}

}  // namespace

Engine production_engine() {
  return {.algorithm_version = 43,
          .evaluate = evaluate,
          .evaluate_edited = evaluate_edited,
          .check_node_limit =
              [](const Revision* base, const FeatureModel& model, const MeshOptions& options,
                 const Run& run) { return check_node_limit(parent(base), model, options, run); },
          .unmeshed = unmeshed,
          .summarise = summary_of,
          .make_revision =
              [](const Revision* base, const ModelSource& source, const MeshOptions& options,
                 const Run& run) { return make_revision(parent(base), source, options, run); },
          .compare = compare,
          .velocities = velocities_of,
          .gradient =
              [](const Revision& revision, const std::vector<Vec3>& seed,
                 const std::vector<std::string>& parameters, const Run& run) {
                return DesignVelocities(revision, run).gradient(seed, parameters, run);
              },
          .horizon = connectivity_horizon,
          .step_of =
              [](const Revision& revision, const ModelLabels& labels, const Run& run) {
                return model_step(revision.model, revision.cells, labels, run);
              },
          .image_of = image_of,
          .revision_of = revision_of,
          .feature_types = [] { return feature_types(); },
          .memory_blocks = memory_blocks,
          .helper_crashes = kernel::tetgen_crashes};
}

}  // namespace remeshd
