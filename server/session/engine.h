#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/stored_array.h"
#include "engine/cellular/model_step.h"
#include "engine/difference/compare.h"
#include "engine/motion/velocities.h"
#include "engine/remesh/forecast.h"
#include "engine/remesh/morph/horizon.h"
#include "engine/remesh/remesh.h"
#include "engine/revision/storage/memory_use.h"

namespace remeshd {

/// What a model amounts to before it is meshed.
struct ModelSummary {
  double volume = 0;  ///< exact
  double area = 0;    ///< of the boundary
  std::uint32_t cells = 0;
  std::uint32_t faces = 0, edges = 0, vertices = 0;  ///< of the merged boundary
  std::vector<Warning> warnings;                     ///< that are certain before there is a mesh
  Forecast forecast{};                               ///< of meshing the whole model
};

/// What the session asks of the engine. A test hands in a quick one; `production_engine()` is the
/// one that meshes.
struct Engine {
  /// Part of every revision's id: raise it whenever the same request gives another mesh.
  std::uint32_t algorithm_version = 1;
  std::function<FeatureModel(const ModelSource&)> evaluate;
  std::function<EvaluatedModel(const ModelSource&, const ModelEdit&)> evaluate_edited;
  /// Checks the limit `Run::max_nodes` as far as can be told before anything is computed; `base`:
  /// null for a first mesh. Returns the least number of nodes that the mesh will have. Throws
  /// Error(`MESH_TOO_LARGE`).
  std::function<double(const Revision* base, const FeatureModel&, const MeshOptions&, const Run&)>
      check_node_limit;
  /// A model as the base of an edit that is only validated. Throws what `build_cells` does.
  std::function<Revision(const FeatureModel&, const Run&)> unmeshed{};
  /// Throws what `make_revision` throws before it meshes; also KERNEL_FAILURE where the CAD kernel
  /// fails on all features together, which an edit may not need.
  std::function<ModelSummary(const Revision* base, const FeatureModel&, const MeshOptions&,
                             const Run&)>
      summarise;
  std::function<Revision(const Revision* base, const ModelSource&, const MeshOptions&, const Run&)>
      make_revision;
  /// The cellular models are those of the two models where they are at hand, else null.
  std::function<ModelComparison(const FeatureModel& original, const FeatureModel& modified,
                                const CellularModel*, const CellularModel*, const Run&)>
      compare;
  /// As `DesignVelocities::of`, for each parameter.
  std::function<std::vector<NodalVelocities>(
      const Revision&, const std::vector<std::string>& parameters, const Run&)>
      velocities{};
  /// As `DesignVelocities::gradient`; `seed`: a vector for each corner node, then each mid-node.
  std::function<std::vector<DesignDerivative>(const Revision&, const std::vector<Vec3>& seed,
                                              const std::vector<std::string>& parameters,
                                              const Run&)>
      gradient{};
  /// As `connectivity_horizon`; `hold`: x edge length.
  std::function<Horizon(const Revision&, const std::string& parameter, double hold, const Run&)>
      horizon{};
  /// The model of a revision as a STEP file, by engine/cellular/model_step.h.
  std::function<std::string(const Revision&, const ModelLabels&, const Run&)> step_of;
  /// See engine/revision/storage/stored_revision.h.
  std::function<StoredArrays(const Revision&)> image_of;
  std::function<Revision(const StoredArrays&, const Revision* alike, const Run&)> revision_of;
  std::function<std::vector<FeatureTypeInfo>()> feature_types;
  std::function<std::vector<MemoryBlock>(const Revision&)> memory_blocks;
  /// How often a helper process has crashed so far; may be empty.
  std::function<std::uint64_t()> helper_crashes{};
};

}  // namespace remeshd
