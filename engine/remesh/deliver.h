#pragma once

#include "engine/remesh/groups.h"
#include "engine/remesh/stages.h"

namespace remeshd {

/// Turns a verified candidate into what is delivered and what the next edit starts from: node and
/// tet maps, permanent ids, groups, master; and counts what was kept.
///
/// `original`: where the nodes were copied from, null if none were; `parent`: the revision that was
/// edited, whose permanent ids are taken in any case, null for a first mesh.
void deliver(Candidate candidate, const Revision* original, const Revision* parent,
             const PointSource& source, Revision& revision, const Run& run);

/// What the report says of a verification.
VerificationFigures figures_of(const Verification& verification);

/// The tets of the original over nodes that stand where `nodes` says, permanent ids and master
/// included; groups stay as they were. `changed_tets`: those that a node of moved, ascending.
void deliver_kept(const Revision& original, Pages<Vec3> nodes,
                  std::span<const std::int32_t> changed_tets, Revision& revision);

/// Groups of the delivered mesh and their areas. `surface`: its boundary facets; `before`: cells
/// that it still has.
void name_delivery(std::span<const SurfaceFacet> surface, const Pages<Support>& supports,
                   const Membership& membership, const CellsBefore& before, Revision& revision,
                   const Run& run);

/// Counts nodes and tets by origin and measures the delivered mesh, of this volume, into
/// `revision.report`; what it was before clean-up too, unless that is the original's. `original`:
/// where it was copied from, null if from nowhere; `remade`: all other tets are measured already.
void account(const Revision* original, std::span<const std::int32_t> remade, double volume,
             Revision& revision, const Run& run);

}  // namespace remeshd
