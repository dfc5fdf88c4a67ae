#pragma once

#include <functional>
#include <string>
#include <vector>

#include "remesh/v1/revision.pb.h"
#include "server/session/session.h"

namespace remeshd {

/// Makes a new revision of a recipe with the algorithm of today: of the parent where that can be
/// had, else of one that was made anew for it in the same way. `made` hears of the revision and of
/// the ids of the ancestors made for it, the furthest first. For the lane of preparations; a parent
/// whose mesh has gone is made again elsewhere, and what comes after goes on by itself.
///
/// Throws Error: what names no revision, or one without a recipe.
MakeRequestPtr remake(
    Session& session, const remesh::v1::RemakeRevisionRequest& request,
    std::function<void(const Made&, const std::vector<std::string>& ancestors)> made,
    std::function<void(const Error&)> failed);

}  // namespace remeshd
