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
/// included; groups stay as they were.
void deliver_kept(const Revision& original, Pages<Vec3> nodes, Revision& revision);

/// Groups of the delivered mesh and their areas. `surface`: its boundary facets; `before`: cells
/// that it still has.
void name_delivery(std::span<const SurfaceFacet> surface, const Pages<Support>& supports,
                   const Membership& membership, const CellsBefore& before, Revision& revision,
                   const Run& run);

/// The tets, ascending, that are not the original's of the same number in place.
std::vector<std::int32_t> remade_tets(const Delivery& delivery, const Run& run);

/// Counts nodes and tets by origin and measures the delivered mesh, of this volume, into
/// `revision.report`. `original`: where it was copied from, null if from nowhere; `remade`: all
/// other tets are measured already.
void account(const Revision* original, std::span<const std::int32_t> remade, double volume,
             Revision& revision, const Run& run);

}  // namespace remeshd
