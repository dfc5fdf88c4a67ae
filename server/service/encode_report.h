#pragma once

#include "engine/base/warning.h"
#include "remesh/v1/report.pb.h"
#include "server/session/held_revision.h"

namespace remeshd {

/// The report of a revision, with the figures of its groups; the caller sets `cached`.
remesh::v1::Report encode_report(const HeldRevision& held);
remesh::v1::Warning encode(const Warning& warning);

}  // namespace remeshd
