#include "server/session/shared_revisions.h"

#include <algorithm>
#include <charconv>
#include <future>
#include <ranges>
#include <utility>

#include "engine/base/error.h"
#include "server/limits.h"
#include "server/session/revision_id.h"
#include "server/store/files.h"
#include "server/store/journal_line.h"
#include "server/store/packed_text.h"
#include "server/tier/sealed_object.h"

namespace remeshd {
namespace {

// Longer chains are not written (packs.cpp).
constexpr std::size_t kMostBases = 64;
// Most meshes that may wait for a tier; of further revisions only the recipes are written.
constexpr std::size_t kMostWaiting = 100'000;

/// The folder of an outbox of a store, in a folder that is made if need be.
std::filesystem::path outbox_folder(const Store& store, const char* name) {
  make_folder(store.folder() / "outbox");
  return store.folder() / "outbox" / name;
}

}  // namespace

SharedRevisions::SharedRevisions(Sharing sharing, const std::string& tenant, Store& store)
    : sharing_(std::move(sharing)),
      prefix_(tenant.empty() ? "" : "tenants/" + tenant + "/"),
      store_(store),
      recipes_(outbox_folder(store, "recipes"), Outbox::Again::InPlace,
               [this](const std::string& id) { write_recipe(id); }),
      meshes_(outbox_folder(store, "meshes"), Outbox::Again::Last,
              [this](const std::string& id) { write_mesh(id); }) {}

std::uint64_t SharedRevisions::first_digits(const std::string& id) {
  std::uint64_t digits = 0;
  std::from_chars(id.data(), id.data() + std::min<std::size_t>(id.size(), 16), digits, 16);
  return digits;
}

std::string SharedRevisions::key_of(const std::string& kind, const std::string& id) const {
  return prefix_ + kind + "/" + id.substr(0, 2) + "/" + id;
}

void SharedRevisions::refuse(const std::string& key, std::string_view object,
                             std::string_view why) {
  {
    const std::scoped_lock lock(mutex_);
    wrong_.insert(key);
  }
  std::string name = key;
  std::ranges::replace(name, '/', '-');
  const std::string note = store_.quarantine("tier-" + name, object, why);
  if (sharing_.tell) sharing_.tell(key + " is not used: " + std::string(why) + "; " + note);
}

bool SharedRevisions::is_wrong(const std::string& key) const {
  const std::scoped_lock lock(mutex_);
  return wrong_.contains(key);
}

std::optional<std::string> SharedRevisions::read(const std::string& key,
                                                 const std::stop_token& stop) {
  if (is_wrong(key)) return std::nullopt;
  const auto object = sharing_.objects->get(key, stop);
  if (!object) return std::nullopt;
  try {
    return unsealed(key, *object, sharing_.farm_key);
  } catch (const WrongObject& why) {
    refuse(key, *object, why.what());
    return std::nullopt;
  }
}

std::optional<SharedRecord> SharedRevisions::find(const std::string& id) {
  if (auto known = find_recipe(id, {})) return known;
  auto found = mesh(id, {});  // which tells its recipe too
  if (!found) return std::nullopt;
  return std::move(found->known);
}

std::optional<SharedRecord> SharedRevisions::find_recipe(const std::string& id,
                                                         const std::stop_token& stop) {
  const std::string key = key_of(kRecipe, id);
  const auto line = read(key, stop);
  if (!line) return std::nullopt;
  try {
    SharedRecord known = shared_record_in(*line, id);
    const std::scoped_lock lock(mutex_);
    published_.insert(first_digits(id));
    return known;
  } catch (const WrongObject& why) {
    refuse(key, *line, why.what());
    return std::nullopt;
  }
}

bool SharedRevisions::has_mesh(const std::string& id, double within) {
  const std::string key = key_of(kPack, id);
  return !is_wrong(key) && sharing_.objects->has(key, within);
}

std::optional<SharedRevisions::Mesh> SharedRevisions::mesh(const std::string& id,
                                                           const std::stop_token& stop) {
  const std::string key = key_of(kPack, id);
  auto pack = read(key, stop);
  if (!pack) return std::nullopt;
  try {
    const auto head = Packs::head_in(*pack);
    if (!head || head->recipe.empty()) throw WrongObject("it is no pack of this version");
    return Mesh{shared_record(head->record, head->recipe, id), std::move(*pack)};
  } catch (const WrongObject& why) {
    refuse(key, *pack, why.what());
    return std::nullopt;
  }
}

std::vector<SharedRevisions::Mesh> SharedRevisions::meshes(const std::string& id,
                                                           const std::stop_token& stop) {
  std::vector<Mesh> chain;
  const auto stored = [&](const std::string& each) {
    return store_.read([&](Catalogue& catalogue) { return catalogue.is_stored(each); });
  };
  for (std::string next = id; !next.empty() && !stored(next);) {
    auto found = chain.size() < kMostBases ? mesh(next, stop) : std::nullopt;
    if (!found) return {};
    next = found->known.record.base;
    chain.push_back(std::move(*found));
  }
  std::ranges::reverse(chain);
  hold_against_recipes(chain, stop);
  return chain;
}

/// Checks the meshes of a chain against the tier's recipes, and takes over when each was made and
/// how long that took. Where a recipe tells other digests, the mesh is refused and the chain
/// emptied.
void SharedRevisions::hold_against_recipes(std::vector<Mesh>& chain, const std::stop_token& stop) {
  std::vector<std::future<std::optional<SharedRecord>>> recipes;
  for (const Mesh& mesh : chain)
    recipes.push_back(std::async(std::launch::async,
                                 [&, id = mesh.known.record.id] { return find_recipe(id, stop); }));
  for (std::size_t i = 0; i < recipes.size(); ++i) {
    const auto told = recipes[i].get();
    if (!told) continue;
    SharedRecord& known = chain[i].known;
    if (told->recipe.digests != known.recipe.digests) {
      put_away(chain[i], "its recipe tells other digests");
      chain.clear();
      return;  // the futures that are left wait for their threads
    }
    known.record.created_ns = told->record.created_ns;
    known.record.seconds = told->record.seconds;
  }
}

void SharedRevisions::put_away(const Mesh& mesh, std::string_view why) {
  refuse(key_of(kPack, mesh.known.record.id), mesh.pack, why);
}

void SharedRevisions::distrust(const std::string& id) {
  const std::scoped_lock lock(mutex_);
  wrong_.insert(key_of(kPack, id));
}

std::string SharedRevisions::parent_of(const std::string& id) const {
  const auto record = store_.read([&](Catalogue& catalogue) { return catalogue.revision(id); });
  return record ? record->parent : std::string();
}

/// Ancestors whose recipes are still to be written, the eldest first.
std::vector<std::string> SharedRevisions::waiting_ancestors(const std::string& id) const {
  std::vector<std::string> waiting;
  for (std::string next = parent_of(id); recipes_.has(next); next = parent_of(next))
    waiting.push_back(next);
  std::ranges::reverse(waiting);
  return waiting;
}

void SharedRevisions::publish(const std::string& id) {
  std::vector<std::string> fresh;
  {
    // What was not asked for in so long may have been taken for garbage.
    const std::scoped_lock lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (now - published_since_ > limits::kTierRefresh) {
      published_.clear();
      published_since_ = now;
    }
  }
  for (std::string next = id; !next.empty(); next = parent_of(next)) {
    const std::scoped_lock lock(mutex_);
    if (!published_.insert(first_digits(next)).second) break;
    fresh.push_back(next);
  }
  // Ancestors first: nothing in the tier is to want for what it is made of.
  for (const std::string& each : fresh | std::views::reverse) {
    recipes_.add(each);
    if (meshes_.size() < kMostWaiting) meshes_.add(each);
  }
  if (!sharing_.acknowledge_in_tier) return;
  for (const std::string& each : waiting_ancestors(id)) recipes_.write_now(each);
  recipes_.write_now(id);
}

void SharedRevisions::mend(const std::string& id) {
  if (is_wrong(key_of(kRecipe, id))) recipes_.add(id);
  if (is_wrong(key_of(kPack, id))) meshes_.add(id);
}

void SharedRevisions::offer(const std::string& id) {
  mend(id);
  meshes_.add(id);
}

namespace {

/// What `read` returns; empty where it throws: what has gone or is damaged is written when it has
/// been made again.
template <typename Read>
std::string where_whole(Read&& read) {
  try {
    return read();
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

void SharedRevisions::write_recipe(const std::string& id) {
  // Several threads write recipes: an ancestor's may be behind.
  for (const std::string& each : waiting_ancestors(id)) recipes_.write_now(each);
  const auto record = store_.read([&](Catalogue& catalogue) { return catalogue.revision(id); });
  const std::string recipe = where_whole([&] { return store_.recipe(id); });
  if (record && !recipe.empty())
    put(key_of(kRecipe, id), line_of(*record, Store::packed_recipe(recipe)));
}

void SharedRevisions::write_mesh(const std::string& id) {
  const std::string key = key_of(kPack, id);
  if (!is_wrong(key) && sharing_.objects->has(key, limits::kTierAnswer)) return;
  const std::string pack = where_whole([&] { return store_.pack(id); });
  if (!pack.empty()) put(key, pack);
}

void SharedRevisions::put(const std::string& key, const std::string& content) {
  const bool wrong = is_wrong(key);
  sharing_.objects->put(key, sealed(key, content, sharing_.farm_key));
  if (!wrong) return;
  const std::scoped_lock lock(mutex_);
  wrong_.erase(key);
}

}  // namespace remeshd
