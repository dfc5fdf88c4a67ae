#pragma once

#include <functional>
#include <string>
#include <vector>

#include "remesh/v1/revision.pb.h"
#include "server/session/session.h"

namespace remeshd {

/// Makes a new revision from the recipe of the one that the request names, with the algorithm of
/// today: as an edit of its parent where the mesh of that can be had, else of a new revision that
/// is made for the parent in the same way. `made` hears of the revision and of the ids of the
/// ancestors made for it, the furthest first; none of these becomes a head. For the lane of
/// preparations; does not wait: a parent whose mesh has gone is fetched, and the steps after that
/// are taken, by other threads.
///
/// Throws Error: what names no revision, or one without a recipe; MISSING_FIELD where nothing says
/// which of several designs is meant.
MakeRequestPtr remake(
    Session& session, const remesh::v1::RemakeRevisionRequest& request,
    std::function<void(const Made&, const std::vector<std::string>& ancestors)> made,
    std::function<void(const Error&)> failed);

}  // namespace remeshd
