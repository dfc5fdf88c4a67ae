#include <chrono>
#include <future>
#include <limits>
#include <map>
#include <set>

#include "server/limits.h"
#include "server/session/clock.h"
#include "server/session/shared_revisions.h"
#include "server/session/tier_garbage.h"
#include "server/store/pack_head.h"
#include "server/tier/sealed_object.h"

// Which objects of the shared tier go.
namespace remeshd {
namespace {

constexpr std::size_t kReaders = 8;

/// Does `work` for each object, several at a time. Throws what one call threw.
template <typename Work>
void for_all(std::vector<SharedObject>& objects, const Work& work) {
  std::vector<std::future<void>> readers;
  for (std::size_t first = 0; first < kReaders; ++first)
    readers.push_back(std::async(std::launch::async, [&, first] {
      for (std::size_t i = first; i < objects.size(); i += kReaders) work(objects[i]);
    }));
  for (std::future<void>& reader : readers) reader.get();
}

std::optional<std::int64_t> seconds_ago(const std::optional<double>& seconds) {
  if (!seconds) return std::nullopt;
  return nanoseconds_now() - static_cast<std::int64_t>(1e9 * *seconds);
}

}  // namespace

std::vector<SharedObject> SharedRevisions::objects_of(const std::string& kind) const {
  std::vector<SharedObject> objects;
  sharing_.objects->list(prefix_ + kind + "/", [&](const ObjectInfo& object) {
    std::string id = object.key.substr(object.key.rfind('/') + 1);
    if (object.key != key_of(kind, id)) return;  // it is none of ours
    objects.push_back(
        {.id = std::move(id), .bytes = object.bytes, .written_ns = object.written_ns});
  });
  return objects;
}

/// The base of a pack, by its head, which is read unchecked: it decides only what is dropped.
std::string SharedRevisions::base_of(const std::string& id) const {
  const auto start = sharing_.objects->start_of(key_of(kPack, id), kMostSealBytes + kMostHeadBytes);
  if (!start) return {};
  const auto head = read_pack_head(after_seal(*start));
  return head ? head->record.base : "";
}

void SharedRevisions::remove(const std::string& kind, const std::vector<SharedObject>& objects) {
  for (const SharedObject& object : objects) {
    sharing_.objects->remove(key_of(kind, object.id));
    const std::scoped_lock lock(mutex_);
    if (kind == kRecipe) published_.erase(first_digits(object.id));
  }
}

/// Ids of the recipes in `go` that were marked more than `kTierRefresh` ago; these may be deleted.
/// Unless `dry_run`, marks the other recipes in `go`, and unmarks those that are not in it. Two
/// steps are needed because a daemon that has seen a recipe in the tier relies on it for up to
/// `kTierRefresh`: within that time it may still write a recipe of a child. A recipe is deleted
/// only if, after that time, no such child has come.
std::set<std::string> SharedRevisions::marked(const std::vector<SharedObject>& go, bool dry_run) {
  std::map<std::string, SharedObject> marks;
  for (SharedObject& mark : objects_of(kDoomed)) marks[mark.id] = mark;
  const std::int64_t long_ago =
      nanoseconds_now() - std::chrono::nanoseconds(limits::kTierRefresh).count();
  std::set<std::string> due;
  for (const SharedObject& recipe : go) {
    const auto mark = marks.extract(recipe.id);
    if (mark.empty()) {
      const std::string key = key_of(kDoomed, recipe.id);
      if (!dry_run) sharing_.objects->put(key, sealed(key, "", sharing_.farm_key));
    } else if (mark.mapped().written_ns < long_ago) {
      due.insert(recipe.id);
    }
  }
  if (dry_run) return due;
  for (const auto& [id, mark] : marks) sharing_.objects->remove(key_of(kDoomed, id));
  return due;
}

/// The recipes to drop from the tier; `kept`: ids of meshes that stay, whose recipes stay too.
std::vector<SharedObject> SharedRevisions::recipes_to_drop(std::vector<SharedObject> recipes,
                                                           const std::set<std::string>& kept,
                                                           const GarbageOptions& options) {
  constexpr auto kAny = std::numeric_limits<std::uint64_t>::max();
  for_all(recipes, [&](SharedObject& recipe) {
    recipe.pinned = kept.contains(recipe.id);
    if (const auto known = find_recipe(recipe.id, {})) recipe.needs = known->recipe.parent;
  });
  const auto after = seconds_ago(options.recipes_unused_seconds);
  const auto due =
      marked(dropped_objects(recipes, kept_objects(recipes, kAny, after)), options.dry_run);
  // What is not due needs its ancestors as long as it is there.
  for (SharedObject& recipe : recipes) recipe.pinned = !due.contains(recipe.id);
  return dropped_objects(recipes,
                         kept_objects(recipes, kAny, std::numeric_limits<std::int64_t>::max()));
}

Collected SharedRevisions::collect_garbage(const GarbageOptions& options) {
  std::vector<SharedObject> packs = objects_of(kPack), recipes = objects_of(kRecipe);
  std::set<std::string> pinned;
  for (const SharedObject& pin : objects_of(kPin)) pinned.insert(pin.id);
  std::uint64_t of_recipes = 0, before = 0;
  for (const SharedObject& recipe : recipes) of_recipes += recipe.bytes;
  for (SharedObject& pack : packs) {
    pack.pinned = pinned.contains(pack.id);
    before += pack.bytes;
  }
  before += of_recipes;

  const std::uint64_t most = options.disk_bytes.value_or(std::numeric_limits<std::uint64_t>::max());
  const std::uint64_t room = most > of_recipes ? most - of_recipes : 0;
  const auto after = seconds_ago(options.unused_seconds);
  if (kept_objects(packs, room, after).size() < packs.size())
    for_all(packs, [&](SharedObject& pack) { pack.needs = base_of(pack.id); });
  std::set<std::string> kept = kept_objects(packs, room, after);
  const std::vector<SharedObject> meshes = dropped_objects(packs, kept);

  std::vector<SharedObject> gone;
  if (options.recipes_unused_seconds) {
    kept.insert(pinned.begin(), pinned.end());
    gone = recipes_to_drop(std::move(recipes), kept, options);
  }
  Collected collected{.meshes = static_cast<std::uint32_t>(meshes.size()),
                      .disk_bytes = before,
                      .recipes = static_cast<std::uint32_t>(gone.size())};
  for (const SharedObject& object : meshes) collected.bytes_freed += object.bytes;
  for (const SharedObject& object : gone) collected.bytes_freed += object.bytes;
  collected.disk_bytes -= collected.bytes_freed;
  if (options.dry_run) return collected;
  remove(kPack, meshes);
  remove(kRecipe, gone);
  remove(kDoomed, gone);
  return collected;
}

void SharedRevisions::set_pin(const std::string& id, bool pinned) {
  const std::string key = key_of(kPin, id);
  if (pinned) {
    sharing_.objects->put(key, sealed(key, "", sharing_.farm_key));
  } else {
    sharing_.objects->remove(key);
  }
}

}  // namespace remeshd
