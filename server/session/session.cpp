#include "server/session/session.h"

#include <algorithm>

#include "server/limits.h"
#include "server/session/mesh_options.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

/// A side of a comparison, resolved.
struct Side {
  HeldRevisionPtr revision;  ///< null for a model that is no revision
  EvaluatedModel at;
};

/// A folder for each tenant: revisions of two tenants may have the same id.
std::filesystem::path dumps_of(const std::string& tenant, const std::filesystem::path& dumps) {
  return tenant.empty() || dumps.empty() ? dumps : dumps / "tenants" / tenant;
}

SharedParts shared_parts(const Sharing& sharing, const std::string& tenant, Store& store) {
  SharedParts parts{.homes = sharing.homes};
  if (sharing.objects) parts.revisions = std::make_unique<SharedRevisions>(sharing, tenant, store);
  if (sharing.designs)
    parts.designs = std::make_unique<SharedDesigns>(sharing.designs, tenant, store);
  return parts;
}

}  // namespace

Session::Session(Resources& resources, std::string tenant, std::unique_ptr<Store> store,
                 const Sharing& sharing)
    : resources_(resources),
      tenant_(std::move(tenant)),
      store_(std::move(store)),
      archive_(engine(), *store_, resources.memory(), &resources.disk(), resources.metrics(),
               shared_parts(sharing, tenant_, *store_)),
      fetcher_(tenant_,
               {archive_, resources.lane(Lane::Preparation), resources.lane(Lane::Computation)}),
      scheduler_({engine(), archive_, fetcher_, resources.memory(),
                  resources.lane(Lane::Preparation), resources.lane(Lane::Computation)},
                 {.threads = limits().threads,
                  .max_nodes = limits().max_nodes,
                  .dumps = dumps_of(tenant_, limits().dumps)}) {}

HeldRevisionPtr Session::get(const std::string& reference, const Run& run) {
  return archive_.get(resolve(reference).id, run);
}

MemoryBudget::Lease Session::take_stream_memory() {
  MemoryBudget& memory = resources_.memory();
  auto lease = memory.try_take(limits::kStreamMemory);
  if (!lease) throw memory.full();
  return lease;
}

MemoryBudget::Lease Session::take_reply_memory(std::uint64_t more, const std::stop_token& stop) {
  MemoryBudget& memory = resources_.memory();
  auto lease = memory.take(std::min<std::uint64_t>(limits::kUntakenBytes + more, memory.total()),
                           stop, limits::kLoadWait);
  Run{.stop = stop, .on_progress = {}, .dumps = {}}.poll();
  return lease;
}

void Session::repair(CacheFault fault, const std::stop_token& stop,
                     std::function<void(const CacheFault&)> done) {
  const auto told = std::make_shared<CacheFault>(std::move(fault));
  fetch(told->revision, stop,
        {.got =
             [this, told, done](const HeldRevisionPtr& revision) {
               told->repaired = archive_.store_again(revision);
               contained([&] { done(*told); });
             },
         .failed =
             [told, done](const Error& why) {
               told->what += "; it cannot be made again: " + why.info().message;
               done(*told);
             }});
}

HeldRevisionPtr Session::parent_of(const HeldRevision& revision, const Run& run) {
  if (revision.record.parent.empty()) return nullptr;
  try {
    return archive_.find(revision.record.parent, run);
  } catch (const Error& failure) {
    if (failure.info().kind == ErrorKind::Cancelled) throw;
    return nullptr;
  }
}

Description Session::describe(const Reference& reference, const Run& run) {
  Description description;
  try {
    description.revision = archive_.at_hand(reference.id, run);
    if (description.revision) description.record = description.revision->record;
  } catch (const Error& why) {
    // Its mesh is damaged, of an older algorithm, or larger than the memory that is left.
    if (why.info().kind == ErrorKind::Cancelled || store_->recipe(reference.id).empty()) throw;
  }
  if (!description.revision) description.recipe = archive_.recipe(reference.id);
  try {
    archive_.look_at_places(reference.id);
  } catch (const Error& failure) {
    // What is named by its id is served all the same, with the places that were known.
    if (failure.info().reason != "CATALOGUE_UNAVAILABLE") throw;
  }
  store_->read([&](Catalogue& catalogue) {
    if (const auto record = catalogue.revision(reference.id)) description.record = *record;
    description.places = catalogue.places(reference.id);
    description.children = catalogue.children(reference.id, limits::kChildren);
    description.durable =
        archive_.is_durable(reference.id) && catalogue.revision(reference.id).has_value();
  });
  if (!description.places.empty()) description.place = description.places.front();
  for (const PlaceRecord& place : description.places)
    if (place.design == reference.design) description.place = place;
  return description;
}

ModelComparison Session::compare(const ComparisonSide& original, const ComparisonSide& modified,
                                 const Run& run) {
  const auto take = [&](const ComparisonSide& side, const char* name) {
    if (const auto* source = std::get_if<ModelSource>(&side))
      return Side{nullptr, {*source, engine().evaluate(*source)}};
    const auto& reference = std::get<std::string>(side);
    if (reference.empty()) throw error::reference_missing(name);
    const auto revision = archive_.get(archive_.resolve(reference).id, run);
    const ModelSource& source = revision->revision.source;
    return Side{revision, {source, engine().evaluate(source)}};
  };
  if (std::holds_alternative<ModelEdit>(original))
    throw error::side_invalid("original", "is an edit; it must be a revision or a model");
  const Side before = take(original, "original");
  const auto* edit = std::get_if<ModelEdit>(&modified);
  const Side after = edit != nullptr
                         ? Side{nullptr, engine().evaluate_edited(before.at.source, *edit)}
                         : take(modified, "modified");
  // A mesh may leave out motions next to nothing: its cells are not those of the document then.
  const auto cells = [](const Side& side) {
    return side.revision && same_geometry(side.revision->revision.model, side.at.model)
               ? &side.revision->revision.cells
               : nullptr;
  };
  return engine().compare(before.at.model, after.at.model, cells(before), cells(after), run);
}

Validated Session::validate(const ModelSource& source, const OptionsPatch& options,
                            const Run& run) {
  return validated(nullptr, {source, engine().evaluate(source)}, first_options(options), run);
}

Validated Session::validated(const Revision* base, EvaluatedModel edited,
                             const MeshOptions& options, Run run) {
  run.max_nodes = limits().max_nodes;
  engine().check_node_limit(base, edited.model, options, run);
  ModelSummary summary = engine().summarise(base, edited.model, options, run);
  return {std::move(edited.source), std::move(summary)};
}

Revision Session::unmeshed(const ModelSource& base, const Run& run) {
  try {
    return engine().unmeshed(engine().evaluate(base), run);
  } catch (Error& why) {
    why.info().message = "the base is no sound model: " + why.info().message;
    throw;
  }
}

Validated Session::validate_edit(const std::variant<std::string, ModelSource>& base,
                                 const ModelEdit& edit, const OptionsPatch& options,
                                 const Run& run) {
  if (const auto* source = std::get_if<ModelSource>(&base)) {
    EvaluatedModel edited = engine().evaluate_edited(*source, edit);
    const Revision original = unmeshed(*source, run);
    return validated(&original, std::move(edited), first_options(options), run);
  }
  const auto& reference = std::get<std::string>(base);
  if (reference.empty()) throw error::reference_missing("base");
  const HeldRevisionPtr held = get(reference, run);
  const Revision& revision = held->revision;
  return validated(&revision, engine().evaluate_edited(revision.source, edit),
                   edit_options(options, revision.options), run);
}

std::vector<ListedRevision> Session::list(const RevisionFilter& filter, const RevisionPage& page) {
  if (filter.design.empty()) {
    archive_.look_at_designs();
  } else {
    archive_.look_at_design(filter.design);
  }
  return store_->read([&](Catalogue& catalogue) {
    if (!filter.design.empty() && !catalogue.design(filter.design))
      throw error::design_not_found(filter.design);
    return catalogue.list(filter, page);
  });
}

std::vector<DesignRecord> Session::designs(const DesignFilter& filter, const DesignPage& page) {
  archive_.look_at_designs();
  return store_->read([&](Catalogue& catalogue) { return catalogue.designs(filter, page); });
}

Load Session::load() {
  const Pool& computation = resources_.lane(Lane::Computation);
  Load load{.running = computation.running(),
            .queued = computation.queued(),
            .waiting = scheduler_.waiting() + fetcher_.waiting(),
            .held = archive_.held().count(),
            .held_bytes = archive_.held().bytes()};
  load.tier_waiting = archive_.tier_waiting();
  load.memory_bytes = load.held_bytes + resources_.memory().leased();
  store_->read([&](Catalogue& catalogue) {
    load.revisions = catalogue.count_revisions();
    load.designs = catalogue.count_designs();
  });
  load.disk_bytes = store_->bytes();
  return load;
}

}  // namespace remeshd
