#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/base/run.h"
#include "engine/base/warning.h"
#include "engine/plan/copy_plan.h"
#include "engine/revision/revision.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// Target edge lengths and density of new nodes, as asked for by the options or inherited.
struct Density {
  SizeField sizes{0};                              ///< target edge lengths
  double weakening = 1;                            ///< of the rules (`SizeRules::field`)
  double nodes_per_volume = 0;                     ///< in newcells
  std::optional<std::uint32_t> count;              ///< in all, of a mesh of new nodes alone
  std::vector<int> fewest_links;                   ///< least links by model edge; empty: even mesh
  bool inherited = false;                          ///< an edit keeps its base's density
  std::vector<SizedBall> dense_places;             ///< `Revision::dense_places`
  std::vector<Warning> warnings;                   ///< details that it does not resolve
  std::shared_ptr<const std::vector<Vec3>> start;  ///< `Budgeted::start`
};

/// The density of a mesh of the model: what the options ask for, else the parent's, of a first mesh
/// the default. No edge length is greater than the parent's.
///
/// Throws Error(InvalidArgument): `OPTIONS_INVALID`; `MESH_TOO_LARGE` where a mesh of this density
/// would need more nodes than `run.max_nodes`; `SELECTOR_EMPTY` where a size control of a first
/// mesh names nothing.
Density resolve_density(const Revision& parent, const MeshOptions& options,
                        const FeatureModel& model, const CellularModel& cells, const Run& run);

/// The lengths that a copy plan goes by, for a base size. Nothing that moves is copied in place for
/// an even mesh: as in the paper, it is copied with its motion.
CopyLengths copy_lengths(double base, bool even);

/// The target edge lengths that a revision was meshed with.
SizeField sizes_of(const Revision& revision, const Run& run);

}  // namespace remeshd
