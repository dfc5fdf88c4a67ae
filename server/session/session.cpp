#include "server/session/session.h"

#include "server/admission/process_memory.h"
#include "server/session/mesh_options.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

constexpr int kMetadataThreads = 2, kPreparationThreads = 4;
constexpr std::size_t kLaneQueue = 1024;
constexpr int kMostChildren = 1000;
/// Of computations: a refusal, health or a progress event does not wait for the end of a worker's
/// turn on the processor.
constexpr int kComputationNiceness = 5;

/// What a side of a comparison comes to.
struct Side {
  HeldRevisionPtr revision;  ///< null for a model that is no revision
  ModelSource source;
};

}  // namespace

Session::Session(Engine engine, std::unique_ptr<Store> store, SessionLimits limits)
    : engine_(std::move(engine)),
      limits_(std::move(limits)),
      store_(std::move(store)),
      memory_(limits_.memory),
      archive_(engine_, *store_, memory_, {.held = limits_.held, .disk = limits_.disk}),
      metadata_({.workers = kMetadataThreads, .queue = kLaneQueue, .wait = limits_.wait}),
      preparation_({.workers = kPreparationThreads, .queue = kLaneQueue, .wait = limits_.wait}),
      computation_({.workers = limits_.workers,
                    .queue = limits_.queue,
                    .wait = limits_.wait,
                    .compute = limits_.compute,
                    .niceness = kComputationNiceness}),
      maker_({engine_, archive_, memory_, preparation_, computation_},
             {.threads = limits_.threads, .max_nodes = limits_.max_nodes, .dumps = limits_.dumps}) {
  memory_.set_process({resident_bytes, return_freed_memory});
}

Session::~Session() { stop(); }

void Session::stop() {
  maker_.stop();
  metadata_.shutdown();
  preparation_.shutdown();
  computation_.shutdown();
}

Pool& Session::pool(Lane lane) {
  switch (lane) {
    case Lane::Metadata:
      return metadata_;
    case Lane::Preparation:
      return preparation_;
    case Lane::Computation:
      break;
  }
  return computation_;
}

HeldRevisionPtr Session::get(const std::string& reference, const Run& run) {
  if (reference.empty()) throw error::reference_missing("revision");
  return archive_.get(archive_.resolve(reference).id, run);
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

Description Session::describe(const std::string& text, const Run& run) {
  if (text.empty()) throw error::reference_missing("revision");
  const Reference reference = archive_.resolve(text);
  Description description;
  description.revision = archive_.get(reference.id, run);
  description.record = description.revision->record;
  store_->read([&](Catalogue& catalogue) {
    if (const auto record = catalogue.revision(reference.id)) description.record = *record;
    description.places = catalogue.places(reference.id);
    description.children = catalogue.children(reference.id, kMostChildren);
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
    if (const auto* source = std::get_if<ModelSource>(&side)) return Side{nullptr, *source};
    const auto& reference = std::get<std::string>(side);
    if (reference.empty()) throw error::reference_missing(name);
    const auto revision = archive_.get(archive_.resolve(reference).id, run);
    return Side{revision, revision->revision.source};
  };
  if (std::holds_alternative<ModelEdit>(original))
    throw error::side_invalid("original", "is an edit; it must be a revision or a model");
  const Side before = take(original, "original");
  const auto* edit = std::get_if<ModelEdit>(&modified);
  const Side after = edit != nullptr ? Side{nullptr, engine_.apply(before.source, *edit)}
                                     : take(modified, "modified");
  const auto cells = [](const Side& side) {
    return side.revision ? &side.revision->revision.cells : nullptr;
  };
  return engine_.compare(engine_.evaluate(before.source), engine_.evaluate(after.source),
                         cells(before), cells(after), run);
}

Validated Session::validate(const ModelSource& source, const OptionsPatch& options,
                            const Run& run) {
  return validated(nullptr, source, first_options(options), run);
}

Validated Session::validated(const Revision* base, const ModelSource& source,
                             const MeshOptions& options, Run run) {
  run.max_nodes = limits_.max_nodes;
  const FeatureModel model = engine_.evaluate(source);
  engine_.check_node_limit(base, model, options, run);
  return {source, engine_.summarise(base, model, options, run)};
}

Validated Session::validate_edit(const std::variant<std::string, ModelSource>& base,
                                 const ModelEdit& edit, const OptionsPatch& options,
                                 const Run& run) {
  const auto* model = std::get_if<ModelSource>(&base);
  if (model != nullptr) return validate(engine_.apply(*model, edit), options, run);
  const auto& reference = std::get<std::string>(base);
  if (reference.empty()) throw error::reference_missing("base");
  const HeldRevisionPtr held = get(reference, run);
  const Revision& revision = held->revision;
  return validated(&revision, engine_.apply(revision.source, edit),
                   edit_options(options, revision.options), run);
}

std::vector<ListedRevision> Session::list(const RevisionFilter& filter, const RevisionPage& page) {
  return store_->read([&](Catalogue& catalogue) {
    if (!filter.design.empty() && !catalogue.design(filter.design))
      throw error::design_not_found(filter.design);
    return catalogue.list(filter, page);
  });
}

std::vector<DesignRecord> Session::designs(const DesignFilter& filter, const DesignPage& page) {
  return store_->read([&](Catalogue& catalogue) { return catalogue.designs(filter, page); });
}

Load Session::load() {
  Load load{.running = computation_.running(),
            .queued = computation_.queued(),
            .waiting = maker_.waiting(),
            .held = archive_.held().count(),
            .held_bytes = archive_.held().bytes()};
  load.memory_bytes = load.held_bytes + memory_.leased();
  store_->read([&](Catalogue& catalogue) {
    load.revisions = catalogue.count_revisions();
    load.designs = catalogue.count_designs();
    load.disk_bytes = catalogue.count_bytes();
  });
  return load;
}

}  // namespace remeshd
