#pragma once

#include "remesh/v1/revision.pb.h"
#include "server/session/session.h"

namespace remeshd {

/// Pages of the lists: at most 1000 rows each, in the order and with the filter asked for.
///
/// Both throw Error: PAGE_TOKEN_INVALID, OPTIONS_INVALID for an unknown order, DESIGN_NOT_FOUND.
remesh::v1::ListRevisionsResponse list_revisions(Session& session,
                                                 const remesh::v1::ListRevisionsRequest& request);
remesh::v1::ListDesignsResponse list_designs(Session& session,
                                             const remesh::v1::ListDesignsRequest& request);

}  // namespace remeshd
