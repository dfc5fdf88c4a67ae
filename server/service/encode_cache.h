#pragma once

#include "remesh/v1/cache.pb.h"
#include "remesh/v1/revision.pb.h"
#include "server/session/cache_entry.h"
#include "server/session/recipe.h"

namespace remeshd {

remesh::v1::CacheEntry encode(const CacheEntry& entry);
remesh::v1::GetCacheStatsResponse encode(const CacheStats& stats);
remesh::v1::CollectGarbageResponse encode(const Collected& collected);

/// The recipe, and the same as JSON: model and edit as documents, all else by the names of the
/// protocol. The same text for the same recipe.
remesh::v1::GetRecipeResponse encode(const Recipe& recipe);

}  // namespace remeshd
