#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/session/archive.h"
#include "server/session/commands.h"
#include "server/session/engine.h"
#include "server/session/fetcher.h"
#include "server/session/resources.h"
#include "server/session/revision_scheduler.h"
#include "server/session/session_error.h"
#include "server/store/store.h"

namespace remeshd {

/// A revision with all that is known of it.
struct Description {
  HeldRevisionPtr revision;      ///< null where its mesh has gone
  std::optional<Recipe> recipe;  ///< in its place
  RevisionRecord record;
  PlaceRecord place;  ///< by which it was named, else its first
  std::vector<PlaceRecord> places;
  std::vector<std::string> children;
  bool durable = false;  ///< it survives the end of the daemon
};

/// A model that was found fit for meshing.
struct Validated {
  ModelSource source;
  ModelSummary summary;
};

struct Load {
  std::size_t running = 0, queued = 0;  ///< computations, of all tenants
  std::size_t waiting = 0;  ///< requests that wait for these; several may wait for the same
  std::size_t held = 0;
  std::uint64_t held_bytes = 0;
  /// `held_bytes`, and all that is leased of the memory budget.
  std::uint64_t memory_bytes = 0;
  std::uint32_t revisions = 0, designs = 0;
  std::uint64_t disk_bytes = 0;
  std::size_t tier_waiting = 0;  ///< objects that the shared tier is still to get
};

/// Everything that the clients of a tenant may do, in the engine's terms, and the tenant's own
/// data. All functions may be called by any thread at the same time. Those with a Run block and
/// belong in a lane (`later`).
class Session {
 public:
  /// `resources` must outlive the session, and be stopped before its end.
  /// `sharing`: its `objects` are null where nothing is shared; otherwise the store must be
  /// persistent.
  Session(Resources& resources, std::string tenant, std::unique_ptr<Store> store,
          const Sharing& sharing = {});
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Lets a request in, before anything else is done for it. As Admission::admit.
  Admission::TicketPtr admit() { return resources_.admission().admit(tenant_); }
  /// As RevisionScheduler::make.
  MakeRequestPtr make(Admission::TicketPtr ticket, std::function<Command()> read,
                      Listener listener) {
    return scheduler_.make(std::move(ticket), std::move(read), std::move(listener));
  }
  /// The same of a command that has been read. Throws what `admit` throws.
  MakeRequestPtr make(Command command, Listener listener) {
    const auto read = [command = std::move(command)] { return command; };
    return make(admit(), read, std::move(listener));
  }

  /// Has work done in the tenant's name. Throws what Pool::submit throws.
  WorkId later(Lane lane, Work work) {
    work.tenant = tenant_;
    return resources_.lane(lane).submit(std::move(work));
  }
  /// Leases memory for the replies of a call that wait for its client (`limits::kUntakenBytes`),
  /// and for `more` bytes. Waits for `limits::kLoadWait` at most. Throws what MemoryBudget::take
  /// throws, Error(Cancelled).
  MemoryBudget::Lease take_reply_memory(std::uint64_t more, const std::stop_token& stop);
  /// Leases memory for a stream that begins. Throws Error: MEMORY_FULL.
  MemoryBudget::Lease take_stream_memory();
  [[nodiscard]] Error no_memory() { return resources_.memory().full(); }
  /// As Pool::withdraw.
  bool withdraw(Lane lane, WorkId id) { return resources_.lane(lane).withdraw(id); }

  /// The revision, made again of its recipe if need be: for the lane of computations.
  HeldRevisionPtr get(const std::string& reference, const Run& run);
  /// The same of an id, for the lane of preparations. As Fetcher::fetch.
  void fetch(const std::string& id, const std::stop_token& stop,
             const Fetcher::Receiver& receiver) {
    fetcher_.fetch(id, stop, receiver);
  }
  /// The revision that another one was made of; null where there is none any more, or none that
  /// can be read.
  HeldRevisionPtr parent_of(const HeldRevision& revision, const Run& run);
  /// All that is known of the revision of a reference. A mesh that has gone is not made again for
  /// it. For the lane of preparations. Throws Error: REVISION_NOT_FOUND, Cancelled, what is wrong
  /// with a mesh that has no recipe.
  Description describe(const Reference& reference, const Run& run);
  ModelComparison compare(const ComparisonSide& original, const ComparisonSide& modified,
                          const Run& run);
  /// Does all checks that are done before a mesh is made, that of the node limit too, and has the
  /// CAD kernel fuse all features together, which an edit may not need.
  Validated validate(const ModelSource& source, const OptionsPatch& options, const Run& run);
  /// The same for the model that the edit makes of a revision or a model.
  Validated validate_edit(const std::variant<std::string, ModelSource>& base, const ModelEdit& edit,
                          const OptionsPatch& options, const Run& run);

  // What the engine says of how a mesh moves with parameters: for the lane of computations.
  [[nodiscard]] std::vector<NodalVelocities> velocities(const Revision& revision,
                                                        const std::vector<std::string>& parameters,
                                                        const Run& run) const {
    return engine().velocities(revision, parameters, run);
  }
  [[nodiscard]] std::vector<DesignDerivative> gradient(const Revision& revision,
                                                       const std::vector<Vec3>& seed,
                                                       const std::vector<std::string>& parameters,
                                                       const Run& run) const {
    return engine().gradient(revision, seed, parameters, run);
  }
  [[nodiscard]] Horizon horizon(const Revision& revision, const std::string& parameter, double hold,
                                const Run& run) const {
    return engine().horizon(revision, parameter, hold, run);
  }

  Archive::Removed remove(const std::string& reference, bool allow_head) {
    return archive_.remove(reference, allow_head);
  }

  /// The exact boundary of a revision's model. Takes a fuse of its features: for the lane of
  /// computations. Throws Error(KERNEL_FAILURE), Error(Cancelled).
  [[nodiscard]] std::string step_of(const HeldRevision& revision, const ModelLabels& labels,
                                    const Run& run) const {
    return engine().step_of(revision.revision, labels, run);
  }

  /// Makes a revision the head of a design that has it. Throws Error: what `resolve` throws,
  /// DESIGN_NOT_FOUND, REVISION_NOT_FOUND where the design has it not, HEAD_CONFLICT.
  Archive::HeadSet set_head(const std::string& reference, const std::string& design,
                            const std::string& expected) {
    return archive_.set_head(reference, design, expected);
  }
  /// Takes all revisions out of a design, and the design off the list.
  /// Throws Error: DESIGN_NOT_FOUND, HEAD_CONFLICT.
  Archive::DesignRemoved remove_design(const std::string& design, const std::string& expected) {
    return archive_.remove_design(design, expected);
  }

  /// The recipe of a revision, whether its mesh is there or not.
  Recipe recipe(const std::string& reference) { return archive_.recipe(resolve(reference).id); }
  /// The same by id. Works also for a deleted revision whose recipe is kept, because other
  /// revisions are made from it.
  Recipe recipe_of_ancestor(const std::string& id) { return archive_.recipe(id); }
  Reference resolve(const std::string& reference) {
    if (reference.empty()) throw error::reference_missing("revision");
    return archive_.resolve(reference);
  }
  /// As Archive::design_of.
  std::string design_of(const std::string& id) { return archive_.design_of(id); }
  /// As Archive::head_of.
  std::string head_of(const std::string& design) { return archive_.head_of(design); }
  /// The archive, for what meshes take in memory and on disk, and which of them stay or go.
  Archive& cache() { return archive_; }
  /// Has a damaged mesh made again and stored. `done` is called with the fault, repaired or with
  /// the reason why not, by any thread, maybe before this returns. For the lane of preparations.
  void repair(CacheFault fault, const std::stop_token& stop,
              std::function<void(const CacheFault&)> done);

  /// Throws Error: DESIGN_NOT_FOUND.
  std::vector<ListedRevision> list(const RevisionFilter& filter, const RevisionPage& page);
  std::vector<DesignRecord> designs(const DesignFilter& filter, const DesignPage& page);
  [[nodiscard]] std::vector<FeatureTypeInfo> feature_types() const {
    return engine().feature_types();
  }
  Load load();
  [[nodiscard]] const SessionLimits& limits() const { return resources_.limits(); }
  [[nodiscard]] std::uint32_t algorithm_version() const { return engine().algorithm_version; }
  /// As Store::on_health. `healthy`: false while the store's disk is full or fails.
  void on_store_health(std::function<void(bool healthy)> listener) {
    store_->on_health(std::move(listener));
  }
  [[nodiscard]] bool persistent() { return archive_.store().persistent(); }

  /// Answers whatever is under way with Unavailable. What still runs comes to its end in the lanes.
  void stop() {
    scheduler_.stop();
    fetcher_.stop();
  }

 private:
  [[nodiscard]] const Engine& engine() const { return resources_.engine(); }
  Revision unmeshed(const ModelSource& base, const Run& run);
  Validated validated(const Revision* base, EvaluatedModel edited, const MeshOptions& options,
                      Run run);

  Resources& resources_;
  const std::string tenant_;
  const std::unique_ptr<Store> store_;
  Archive archive_;
  Fetcher fetcher_;
  RevisionScheduler scheduler_;
};

}  // namespace remeshd
