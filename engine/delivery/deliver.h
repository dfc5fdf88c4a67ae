#pragma once

#include "engine/delivery/groups.h"
#include "engine/patch/candidate.h"

namespace remeshd {

/// Turns a verified candidate into what is delivered and what the next edit starts from: node and
/// tet maps, permanent ids, groups, Delaunay state; and counts what was kept.
///
/// `original`: the revision that nodes and tets were copied from. `parent`: the revision that was
/// edited; new nodes and tets get permanent ids that neither it nor its ancestors have used. Either
/// may be `Revision::none()`.
void deliver(Candidate candidate, const Revision& original, const Revision& parent,
             const CopyPlan& plan, Revision& revision, const Run& run);

/// What the report says of a verification.
VerificationFigures figures_of(const Verification& verification);

/// Delivers the original's tets with the nodes at `nodes`; permanent ids, Delaunay state and groups
/// are the original's. `changed_tets`: those with a node that moved, ascending.
void deliver_kept(const Revision& original, CowVector<Vec3> nodes,
                  std::span<const std::int32_t> changed_tets, Revision& revision);

/// Names the facets and tets of the output mesh (`name_groups`) and measures the areas of its
/// groups of facets (`group_areas`).
void name_output(std::span<const SurfaceFacet> surface, const CowVector<Support>& supports,
                 const Membership& membership, const CellsBefore& before, Revision& revision,
                 const Run& run);

/// Writes into `revision.report` the numbers of nodes and tets by origin, the quality of the output
/// mesh and its `volume`; also the quality before clean-up, unless the Delaunay state is the
/// original's. Writes the measures of the tets into `revision.measures`. `original`: the revision
/// that the mesh was copied from; `remade`: the tets to be measured; all others have the original's
/// measures.
void account(const Revision& original, std::span<const std::int32_t> remade, double volume,
             Revision& revision, const Run& run);

}  // namespace remeshd
