#pragma once

#include "engine/delivery/groups.h"
#include "engine/patch/candidate.h"

namespace remeshd {

/// Turns a verified candidate into what is delivered and what the next edit starts from: node and
/// tet maps, permanent ids, groups, Delaunay state; and counts what was kept.
///
/// `original`: where the nodes were copied from; `parent`: the revision that was edited, whose
/// permanent ids are taken in any case. Either may be `Revision::none()`.
void deliver(Candidate candidate, const Revision& original, const Revision& parent,
             const CopyPlan& plan, Revision& revision, const Run& run);

/// What the report says of a verification.
VerificationFigures figures_of(const Verification& verification);

/// The tets of the original over nodes that stand where `nodes` says, permanent ids and Delaunay
/// state included; groups stay as they were. `changed_tets`: those that a node of moved, ascending.
void deliver_kept(const Revision& original, CowVector<Vec3> nodes,
                  std::span<const std::int32_t> changed_tets, Revision& revision);

/// Groups of the output mesh and their areas. `surface`: its boundary facets; `before`: cells
/// that it still has.
void name_output(std::span<const SurfaceFacet> surface, const CowVector<Support>& supports,
                 const Membership& membership, const CellsBefore& before, Revision& revision,
                 const Run& run);

/// Counts nodes and tets by origin and measures the output mesh, of this volume, into
/// `revision.report`; what it was before clean-up too, unless that is the original's. `original`:
/// where it was copied from; `remade`: all other tets are measured already.
void account(const Revision& original, std::span<const std::int32_t> remade, double volume,
             Revision& revision, const Run& run);

}  // namespace remeshd
