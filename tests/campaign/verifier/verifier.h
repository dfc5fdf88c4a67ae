#pragma once

#include <cstdint>
#include <set>

#include "engine/remesh/remesh.h"
#include "tests/campaign/verifier/findings.h"

namespace remeshd::campaign {

/// Checks a revision's mesh against its model with nothing of the engine but the features' closed
/// formulas: exact surfaces and membership. What each check asks stands above its function in the
/// check_*.cpp files.
///
/// `base`: the revision that was edited, null for a first mesh. `node_ids`, `tet_ids`: all
/// permanent ids that ancestors had; those of this revision are added.
Findings verify_independently(const Revision& revision, const Revision* base,
                              std::set<std::uint64_t>& node_ids, std::set<std::uint64_t>& tet_ids);

/// The parts, for tests. `facets`: those in one tet only, outward.
std::vector<Triangle> check_connectivity(const TetMesh& mesh, Findings& findings);
void check_shape(const Revision& revision, const std::vector<Triangle>& facets, Findings& findings);
void check_names(const Revision& revision, const std::vector<Triangle>& facets, Findings& findings);
void check_maps(const Revision& revision, const Revision* base, std::set<std::uint64_t>& node_ids,
                std::set<std::uint64_t>& tet_ids, Findings& findings);

}  // namespace remeshd::campaign
