#pragma once

#include "remesh/v1/cache.pb.h"
#include "server/session/session.h"

namespace remeshd {

/// A page of what the cache holds.
/// Throws Error(InvalidArgument): an unknown order, `PAGE_TOKEN_INVALID`.
remesh::v1::ListCacheEntriesResponse list_cache_entries(
    Session& session, const remesh::v1::ListCacheEntriesRequest& request);

}  // namespace remeshd
