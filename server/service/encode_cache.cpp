#include "server/service/encode_cache.h"

#include <nlohmann/json.hpp>

#include "proto/document.h"
#include "proto/json_writer.h"
#include "server/service/encode.h"
#include "server/service/encode_model.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

v1::CacheEntry::State encode(MeshState state) {
  switch (state) {
    case MeshState::Stored:
      return v1::CacheEntry::STATE_STORED;
    case MeshState::Memory:
      return v1::CacheEntry::STATE_MEMORY;
    case MeshState::Recipe:
      return v1::CacheEntry::STATE_RECIPE;
    case MeshState::Outdated:
      return v1::CacheEntry::STATE_OUTDATED;
  }
  return v1::CacheEntry::STATE_UNSPECIFIED;
}

std::string document_of(const v1::Recipe& recipe, const std::string& edit) {
  using nlohmann::ordered_json;
  ordered_json digests = ordered_json::object();
  for (const v1::Recipe::Digest& digest : recipe.digests())
    digests[v1::MeshArray_Name(digest.array())] = digest.digest();
  ordered_json out{{"revision", recipe.revision()},
                   {"parent", recipe.parent()},
                   {"algorithm_version", recipe.algorithm_version()},
                   {"model", ordered_json::parse(write_document(recipe.model()))}};
  if (!edit.empty()) out["edit"] = ordered_json::parse(edit);
  out["options"] = ordered_json::parse(write_json(recipe.options()));
  out["digests"] = std::move(digests);
  return out.dump(2) + "\n";
}

}  // namespace

v1::CacheEntry encode(const CacheEntry& entry) {
  v1::CacheEntry out;
  out.set_revision(entry.record.id);
  out.set_state(encode(entry.state));
  out.set_pinned(entry.record.pinned);
  out.set_disk_bytes(entry.record.bytes);
  out.set_memory_bytes(entry.memory_bytes);
  out.set_depth(static_cast<std::uint32_t>(entry.depth));
  out.set_places(entry.places);
  out.set_algorithm_version(entry.record.algorithm_version);
  put_time(entry.record.created_ns, *out.mutable_created());
  put_time(entry.used_ns, *out.mutable_used());
  return out;
}

v1::GetCacheStatsResponse encode(const CacheStats& stats) {
  v1::GetCacheStatsResponse out;
  out.set_stored(stats.stored);
  out.set_in_memory(stats.in_memory);
  out.set_recipes(stats.recipes);
  out.set_outdated(stats.outdated);
  out.set_pinned(stats.pinned);
  out.set_quarantined(stats.quarantined);
  out.set_disk_bytes(stats.disk_bytes);
  out.set_disk_budget_bytes(stats.disk_budget);
  out.set_disk_free_bytes(stats.disk_free);
  out.set_memory_bytes(stats.memory_bytes);
  out.set_memory_budget_bytes(stats.memory_budget);
  out.set_hits(stats.hits);
  out.set_misses(stats.misses);
  out.set_evictions(stats.evictions);
  out.set_remade(stats.remade);
  return out;
}

v1::CollectGarbageResponse encode(const Collected& collected) {
  v1::CollectGarbageResponse out;
  out.set_recipes(collected.recipes);
  out.set_meshes(collected.meshes);
  out.set_bytes_freed(collected.bytes_freed);
  out.set_disk_bytes(collected.disk_bytes);
  return out;
}

v1::GetRecipeResponse encode(const Recipe& recipe) {
  v1::GetRecipeResponse out;
  v1::Recipe& message = *out.mutable_recipe();
  message.set_revision(recipe.revision);
  message.set_parent(recipe.parent);
  message.set_algorithm_version(recipe.algorithm_version);
  *message.mutable_model() = encode(recipe.model);
  if (!recipe.edit.empty())
    *message.mutable_edit() = parse_edit(recipe.edit, {.bytes = recipe.edit.size()});
  *message.mutable_options() = encode(recipe.options);
  for (const Recipe::Digest& digest : recipe.digests) {
    v1::Recipe::Digest& entry = *message.add_digests();
    entry.set_array(static_cast<v1::MeshArray>(digest.array));
    entry.set_digest(digest.digest);
  }
  out.set_document(document_of(message, recipe.edit));
  return out;
}

}  // namespace remeshd
