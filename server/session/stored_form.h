#pragma once

#include <memory>

#include "server/session/engine.h"
#include "server/session/held_revision.h"

namespace remeshd {

/// All that a revision is stored as: the engine's arrays and the document of the edit. They lie in
/// the revision, which has to outlive them. Equal revisions give equal arrays.
StoredArrays stored_form(const Engine& engine, const HeldRevision& held);

/// The revision of a record, from its arrays. `alike`: a revision whose memory is shared where the
/// content is the same; null for none. Throws Error(Internal).
std::shared_ptr<HeldRevision> restored(const Engine& engine, const StoredArrays& arrays,
                                       const RevisionRecord& record, const HeldRevision* alike,
                                       const Run& run);

/// Puts the seconds that the record has kept, if any, into the report.
void tell_seconds(HeldRevision& held);
/// The seconds of a report that a record keeps: those of its phases, attempts and geometry.
std::vector<double> seconds_of(const Report& report);

}  // namespace remeshd
