#include <algorithm>
#include <exception>

#include "server/limits.h"
#include "server/session/archive.h"
#include "server/session/clock.h"
#include "server/session/session_error.h"
#include "server/session/stored_form.h"
#include "server/session/written_mesh.h"

// How the archive comes by meshes: from memory, from the store, or made again of their recipes.
namespace remeshd {
namespace {

/// Bytes that a revision and what it is read from take together.
std::uint64_t loading_memory(const RevisionRecord& record) {
  return limits::kBytesPerNode * record.nodes;
}

/// Bytes that making a revision of its recipe needs at its peak, as far as can be told.
std::uint64_t remaking_memory(const Recipe& recipe, const RevisionRecord& record,
                              const HeldRevision* parent) {
  std::uint64_t nodes = std::max(record.nodes, recipe.options.nodes.value_or(0));
  if (parent != nullptr) nodes = std::max<std::uint64_t>(nodes, parent->record.nodes);
  return limits::kBytesPerNode * nodes;
}

/// A revision without a mesh, and the turn to make that again.
struct ToRemake {
  std::string id;
  OneAtATime::Turn turn;
};

}  // namespace

HeldRevisionPtr Archive::find(const std::string& id, const Run& run) {
  HeldRevisionPtr held;
  try {
    held = look_up(id, run);
  } catch (...) {
    count_use(id, false);
    throw;
  }
  count_use(id, held != nullptr);
  return held;
}

void Archive::count_use(const std::string& id, bool hit) {
  if (hit) note_use(id);
  const std::scoped_lock lock(notes_);
  ++(hit ? hits_ : misses_);
}

Archive::Reading Archive::read(const std::string& id, const Run& run) {
  try {
    return {look_up(id, run), nullptr};
  } catch (const Error& failure) {
    if (failure.info().kind != ErrorKind::Internal) throw;
    return {nullptr, std::current_exception()};
  }
}

HeldRevisionPtr Archive::at_hand(const std::string& id, const Run& run) {
  const Reading reading = read(id, run);
  if (reading.held) count_use(id, true);  // a miss is counted where the mesh is made again
  if (reading.held || (store_.persistent() && recipe_to_follow(id))) return reading.held;
  if (reading.damage) std::rethrow_exception(reading.damage);
  throw error::revision_not_found(id, "it was deleted a moment ago");
}

void Archive::count(Metrics::CacheResult where) const {
  if (metrics_ != nullptr) metrics_->cache_request(where);
}

HeldRevisionPtr Archive::look_up(const std::string& id, const Run& run) {
  using enum Metrics::CacheResult;
  auto held = held_.find(id);
  if (held) count(Memory);
  if (held || !store_.persistent()) return held;
  const auto turn = loading_.take(id, run);
  held = held_.find(id);  // another one may have loaded it
  if (held) count(Memory);
  if (held) return held;
  const auto record = store_.read([&](Catalogue& catalogue) { return catalogue.revision(id); });
  if (!record) return nullptr;
  if (record->bytes == 0) return look_up_shared(id, run);
  try {
    held = load(*record, run);
  } catch (const Error& failure) {
    // Where the mesh was dropped meanwhile, nothing is damaged.
    if (failure.info().kind != ErrorKind::Internal || is_stored(id)) throw;
    return look_up_shared(id, run);
  }
  count(Disk);
  return held;
}

HeldRevisionPtr Archive::load(const RevisionRecord& record, const Run& run) {
  const auto share =
      memory_.take(std::min(loading_memory(record), memory_.total()), run.stop, limits::kLoadWait);
  run.poll();
  try {
    const HeldRevisionPtr parent = held_.find(record.parent);
    auto held = restored(engine_, store_.get(record.id), record, parent.get(), run);
    if (shared_) check_digests(*held);
    held_.insert(held);
    return held;
  } catch (const Error& failure) {
    if (failure.info().kind == ErrorKind::Internal && is_stored(record.id))
      set_damaged(record.id, true);
    throw;
  }
}

HeldRevisionPtr Archive::get(const std::string& id, const Run& run) {
  auto held = obtain(id, run);
  if (!held) throw error::revision_not_found(id, "it was deleted a moment ago");
  return held;
}

HeldRevisionPtr Archive::obtain(const std::string& id, const Run& run) {
  // Goes up the chain of parents to a mesh that is at hand, or to the first mesh of all.
  std::vector<ToRemake> to_remake;
  HeldRevisionPtr held;
  std::exception_ptr damage;  // of the last that could not be read
  for (std::string next = id; !next.empty();) {
    if (shared_ && !is_known(next)) adopt(next);
    const Reading reading = read(next, run);
    count_use(next, reading.held != nullptr);
    held = reading.held;
    if (held) break;
    if (!store_.persistent()) return nullptr;
    if (reading.damage) damage = reading.damage;
    const std::optional<Recipe> recipe = recipe_to_follow(next);
    if (!recipe && damage) std::rethrow_exception(damage);
    if (!recipe) return nullptr;
    auto turn = remaking_.take(next, run);
    held = held_.find(next);  // somebody else may have made it meanwhile
    if (held) break;
    to_remake.push_back({next, std::move(turn)});
    next = recipe->parent;
  }
  for (; !to_remake.empty(); to_remake.pop_back()) held = remake(to_remake.back().id, held, run);
  return held;
}

std::optional<Recipe> Archive::recipe_to_follow(const std::string& id) {
  const std::string text = recipe_text(id);
  if (text.empty()) return std::nullopt;
  Recipe recipe = read_recipe(text);
  if (recipe.algorithm_version != engine_.algorithm_version)
    throw error::revision_outdated(id, recipe.algorithm_version, engine_.algorithm_version);
  return recipe;
}

HeldRevisionPtr Archive::remake(const std::string& id, const HeldRevisionPtr& parent,
                                const Run& run) {
  const std::optional<Recipe> followed = recipe_to_follow(id);
  if (!followed) throw error::revision_not_found(id, "it was deleted a moment ago");
  const Recipe& recipe = *followed;
  const auto record = store_.read([&](Catalogue& catalogue) { return catalogue.revision(id); });
  if (parent && record && record->bytes > 0) {
    // The stored pack may be intact: what failed to load may have been its base, the parent's pack,
    // which has been repaired by now.
    try {
      auto held = load(*record, run);
      set_damaged(id, false);
      return held;
    } catch (const Error& failure) {
      if (failure.info().kind != ErrorKind::Internal) throw;
    }
  }

  auto made = std::make_shared<HeldRevision>();
  made->record = record.value_or(RevisionRecord{.id = id,
                                                .parent = recipe.parent,
                                                .model_name = recipe.model.name,
                                                .algorithm_version = recipe.algorithm_version});
  made->edit = recipe.edit;
  made->asked = recipe.options;
  const std::uint64_t bytes = remaking_memory(recipe, made->record, parent.get());
  const auto share = memory_.take(std::min(bytes, memory_.total()), run.stop, limits::kLoadWait);
  run.poll();
  made->revision = engine_.make_revision(parent ? &parent->revision : nullptr, recipe.model,
                                         recipe.options, run);
  made->revision.report.revision = id;
  made->revision.report.cached = false;
  tell_seconds(*made);
  if (recipe_of(*made).digests != recipe.digests) throw error::not_reproducible(id);
  held_.insert(made);
  if (record) note_use(id);  // a note stays until its revision is deleted
  count(Metrics::CacheResult::Remade);
  {
    const std::scoped_lock lock(notes_);
    ++remade_;
  }
  try {
    keep(made);
    if (shared_) shared_->offer(id);
  } catch (const Error&) {
    // The mesh is served all the same; if it leaves memory, it is made again when it is asked for.
  }
  return made;
}

Recipe Archive::recipe(const std::string& id) {
  const std::string text = recipe_text(id);
  if (!text.empty()) return read_recipe(text);
  const HeldRevisionPtr held = held_.find(id);
  if (held && held->asked) return recipe_of(*held);
  throw error::revision_not_found(id, "it was stored by an older version, without a recipe");
}

void Archive::hold(HeldRevisionPtr revision) {
  check_reproduced(*revision);
  held_.insert(std::move(revision));
}

void Archive::check_reproduced(const HeldRevision& revision) {
  const std::string& id = revision.record.id;
  if (!store_.persistent() || !revision.asked || !is_known(id)) return;
  const std::string text = store_.recipe(id);
  if (!text.empty() && read_recipe(text).digests != recipe_of(revision).digests)
    throw error::not_reproducible(id);
}

Archive::Written Archive::write(const HeldRevision& revision, const PlaceRecord& place,
                                bool by_itself) {
  Written written{.record = revision.record};
  written.record.seconds = seconds_of(revision.revision.report);
  const HeldRevisionPtr parent = held_.find(written.record.parent);
  const std::string recipe = revision.asked ? write_recipe(recipe_of(revision, parent.get()))
                                            : store_.recipe(written.record.id);
  written.recipe = Store::packed_recipe(recipe);
  const StoredArrays arrays = stored_form(engine_, revision);
  if (!parent || by_itself) {
    store_.put(written.record, place, recipe, arrays);
  } else {
    const StoredArrays of_parent = stored_form(engine_, *parent);
    const Packs::Base base{written.record.parent, &of_parent};
    store_.put(written.record, place, recipe, arrays, &base);
  }
  return written;
}

Archive::Written Archive::write_if_there_is_room(const HeldRevision& revision,
                                                 const PlaceRecord& place) {
  try {
    return write(revision, place, false);
  } catch (const Error& failure) {
    if (failure.info().reason != "STORE_FULL") throw;
    Written unwritten{.record = revision.record};
    unwritten.record.seconds = seconds_of(revision.revision.report);
    if (revision.asked) unwritten.recipe = Store::packed_recipe(write_recipe(recipe_of(revision)));
    return unwritten;
  }
}

void Archive::set_unsaved(const std::string& id, bool unsaved) {
  const std::scoped_lock lock(notes_);
  if (unsaved) {
    unsaved_.insert(id);
  } else {
    unsaved_.erase(id);
  }
}

bool Archive::is_durable(const std::string& id) const {
  const std::scoped_lock lock(notes_);
  return store_.persistent() && !unsaved_.contains(id);
}

bool Archive::recover() {
  store_.flush();
  std::set<std::string> unsaved;
  {
    const std::scoped_lock lock(notes_);
    unsaved = unsaved_;
  }
  for (const std::string& id : unsaved) {
    // One that left memory is made again of its recipe, which is on the disk by now.
    if (const HeldRevisionPtr held = held_.find(id)) keep(held);
    set_unsaved(id, false);
  }
  store_.try_disk();  // last: until all is saved the store must not count as healthy
  return false;
}

void Archive::keep(const HeldRevisionPtr& revision) {
  const std::string& id = revision->record.id;
  const auto lacking = [&] { return is_damaged(id) || !is_stored(id); };
  if (!store_.persistent() || !lacking()) return;
  const auto turn = writing_.take(id);
  if (!is_known(id) || !lacking()) return;
  // A damaged one without a base: packs whose base it is must not get longer chains.
  Written written = write(*revision, first_place(id), is_damaged(id));
  store_.commit([&](Catalogue& catalogue) {
    auto record = catalogue.revision(id);
    if (!record) return Transaction{};  // it was deleted meanwhile
    record->bytes = written.record.bytes;
    record->base = written.record.base;
    return Transaction{AddRevision{*record, written.recipe}};
  });
  store_.discard(id);
  set_damaged(id, false);
  if (disk_ != nullptr) disk_->look_soon();
}

bool Archive::store_again(const HeldRevisionPtr& revision) {
  keep(revision);
  return !is_damaged(revision->record.id);
}

bool Archive::is_damaged(const std::string& id) const {
  const std::scoped_lock lock(notes_);
  return damaged_.contains(id);
}

void Archive::set_damaged(const std::string& id, bool damaged) {
  const std::scoped_lock lock(notes_);
  if (damaged) {
    damaged_.insert(id);
  } else {
    damaged_.erase(id);
  }
}

bool Archive::is_known(const std::string& id) {
  return store_.read([&](Catalogue& catalogue) { return catalogue.revision(id).has_value(); });
}

bool Archive::is_stored(const std::string& id) {
  return store_.read([&](Catalogue& catalogue) { return catalogue.is_stored(id); });
}

PlaceRecord Archive::first_place(const std::string& id) {
  return store_.read([&](Catalogue& catalogue) {
    const auto places = catalogue.places(id);
    return places.empty() ? PlaceRecord{.id = id} : places.front();
  });
}

void Archive::note_use(const std::string& id) {
  const std::scoped_lock lock(notes_);
  used_[id] = nanoseconds_now();
}

}  // namespace remeshd
