#include <algorithm>

#include "server/limits.h"
#include "server/session/archive.h"
#include "server/session/session_error.h"
#include "server/session/shared_revisions.h"
#include "server/store/store_error.h"

// How the archive uses the shared tier.
namespace remeshd {

void Archive::adopt(const std::string& id) {
  const auto turn = loading_.take(id);
  if (is_known(id) || bring(id, {})) return;
  const auto known = shared_->find(id);
  if (!known) return;
  store_.commit([&](Catalogue& catalogue) {
    if (catalogue.revision(id)) return Transaction{};
    return Transaction{AddRevision{known->record, known->packed_recipe}};
  });
}

std::string Archive::recipe_text(const std::string& id) {
  std::string text = store_.recipe(id);
  if (!text.empty() || !shared_) return text;
  const auto known = shared_->find(id);
  if (!known) return {};
  store_.commit([&](Catalogue& catalogue) {
    return Transaction{
        AddRevision{catalogue.revision(id).value_or(known->record), known->packed_recipe}};
  });
  return store_.recipe(id);
}

HeldRevisionPtr Archive::look_up_shared(const std::string& id, const Run& run) {
  try {
    if (!shared_ || !shared_->has_mesh(id, limits::kTierLookUp)) return nullptr;
    return bring(id, run);
  } catch (const Error& failure) {
    if (failure.info().reason != "TIER_UNAVAILABLE") throw;
    return nullptr;
  }
}

HeldRevisionPtr Archive::bring(const std::string& id, const Run& run) {
  std::vector<SharedRevisions::Mesh> chain = shared_->meshes(id, run.stop);
  for (SharedRevisions::Mesh& mesh : chain) {
    try {
      take_in(mesh);
    } catch (const Error& failure) {
      if (failure.info().reason != "STORE_CORRUPTED") throw;
      shared_->put_away(mesh, failure.info().message);
      return nullptr;
    }
  }
  if (chain.empty()) return nullptr;
  const auto record = store_.read([&](Catalogue& catalogue) { return catalogue.revision(id); });
  if (!record || record->bytes == 0) return nullptr;
  HeldRevisionPtr held;
  try {
    held = load(*record, run);
  } catch (const Error& failure) {
    if (failure.info().kind != ErrorKind::Internal) throw;
    shared_->put_away(chain.back(), failure.info().message);
    return nullptr;
  }
  for (const SharedRevisions::Mesh& mesh : chain) shared_->mend(mesh.known.record.id);
  count(Metrics::CacheResult::Tier);
  return held;
}

void Archive::check_digests(const HeldRevision& held) {
  const std::string& id = held.record.id;
  const std::string text = store_.recipe(id);
  if (text.empty()) return;
  const auto digests = digests_of(held);
  const auto is_told = [&](const Recipe::Digest& digest) {
    return std::ranges::find(digests, digest) != digests.end();
  };
  if (std::ranges::all_of(read_recipe(text).digests, is_told)) return;
  shared_->distrust(id);
  throw error::store_corrupted(id, "its arrays have not the digests of its recipe");
}

void Archive::take_in(const SharedRevisions::Mesh& mesh) {
  const std::string& id = mesh.known.record.id;
  const auto turn = writing_.take(id);
  if (is_stored(id)) return;
  RevisionRecord record = mesh.known.record;
  store_.take_in(record, mesh.pack);
  store_.commit([&](Catalogue& catalogue) {
    RevisionRecord entered = catalogue.revision(id).value_or(record);
    entered.bytes = record.bytes;
    entered.base = record.base;
    return Transaction{AddRevision{entered, mesh.known.packed_recipe}};
  });
  set_damaged(id, false);
  if (disk_ != nullptr) disk_->look_soon();
}

HeldRevisionPtr Archive::find_shared(const std::string& id, const Run& run) {
  if (shared_ == nullptr || !shared_->has_mesh(id, limits::kTierLookUp)) return nullptr;
  const auto turn = loading_.take(id, run);
  if (auto held = held_.find(id)) return held;
  return bring(id, run);
}

Collected Archive::collect_tier_garbage(const GarbageOptions& options) {
  if (!shared_) throw error::option_invalid("tier", "asks for a shared tier, and there is none");
  return shared_->collect_garbage(options);
}

void Archive::publish(const std::string& id) {
  if (shared_ != nullptr) shared_->publish(id);
}

}  // namespace remeshd
