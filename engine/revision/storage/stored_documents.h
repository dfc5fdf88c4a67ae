#pragma once

#include <string>

#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/revision/delaunay_state.h"
#include "engine/revision/revision.h"

namespace remeshd {

/// What a revision has beside its arrays, in one piece: models and options as written, the parts of
/// its boundary, names of groups and cells, the report, and single numbers. The struct has what is
/// not put into the revision on reading.
struct Documents {
  BoundaryParts parts;
  DelaunayState delaunay_state;  ///< but for its arrays
  bool anchored = false;
  bool has_figures = false;  ///< of groups, which older formats have not
  ModelSource anchor_source;
};

std::string write_documents(const Revision& revision);

/// Puts what belongs into the revision itself there, and returns the rest.
/// Throws Error(Internal) on malformed bytes, and on those of an unknown format.
Documents read_documents(const std::string& bytes, Revision& revision);

}  // namespace remeshd
