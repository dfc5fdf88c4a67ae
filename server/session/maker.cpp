#include "server/session/maker.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "server/session/clock.h"
#include "server/session/fail_on.h"
#include "server/session/guarded.h"
#include "server/session/revision_id.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

void check_options(const OptionsPatch& patch) {
  if (patch.nodes && patch.size)
    throw error::option_invalid("nodes", "and `size` exclude each other");
  if (patch.nodes && *patch.nodes < 20) throw error::option_invalid("nodes", "is less than 20");
  if (patch.size && !(std::isfinite(*patch.size) && *patch.size > 0))
    throw error::option_invalid("size", "is not a positive length");
  if (patch.iterations && *patch.iterations > 1000)
    throw error::option_invalid("iterations", "is more than 1000");
  if (patch.threshold && !(*patch.threshold >= 0 && *patch.threshold <= 0.8))
    throw error::option_invalid("threshold", "is not between 0 and 0.8");
}

/// Tells a listener of progress, if it wants to hear of it.
void report(const Listener& listener, const Progress& progress) {
  if (listener.progress) contained([&] { listener.progress(progress); });
}

}  // namespace

/// A command made definite.
struct Maker::Prepared {
  std::string id;
  std::string design;
  HeadRule head;
  std::vector<WarningCode> fail_on;
  HeldRevisionPtr base;  ///< null for a first mesh
  std::string edit;      ///< its document
  ModelSource source;
  MeshOptions options;
  int threads = 1;
};

struct Maker::Request : MakeRequest {
  Maker* maker = nullptr;
  Listener listener;
  std::string design;
  HeadRule head;
  std::vector<WarningCode> fail_on;
  std::stop_source stop;              ///< of its preparation
  std::weak_ptr<Computation> joined;  ///< guarded by the maker's mutex
  std::atomic<bool> answered = false;
  std::weak_ptr<Request> self;

  void cancel() override {
    const RequestPtr request = self.lock();
    if (!request || answered) return;
    stop.request_stop();
    maker->fail(request, error::cancelled());
  }
};

struct Maker::Computation {
  Prepared prepared;
  std::stop_source stop;
  Pool::JobId job = 0;
  std::vector<RequestPtr> requests;  ///< guarded by the maker's mutex
};

Maker::Maker(const Engine& engine, Archive& archive, Pool& quick, Pool& workers, Limits limits)
    : engine_(engine),
      archive_(archive),
      quick_(quick),
      workers_(workers),
      limits_(std::move(limits)) {}

Maker::~Maker() { stop(); }

MeshOptions Maker::first_options(const OptionsPatch& patch) {
  check_options(patch);
  constexpr std::uint32_t kDefaultNodes = 15000;
  MeshOptions options;
  options.nodes = patch.nodes;
  options.size = patch.size;
  if (!options.nodes && !options.size) options.nodes = kDefaultNodes;
  options.iterations = patch.iterations.value_or(options.iterations);
  options.seed = patch.seed.value_or(options.seed);
  options.inside = patch.inside.value_or(options.inside);
  options.start = patch.start.value_or(options.start);
  options.threshold = patch.threshold.value_or(options.threshold);
  options.clean_up = patch.clean_up.value_or(options.clean_up);
  return options;
}

MeshOptions Maker::edit_options(const OptionsPatch& patch, const MeshOptions& base) {
  check_options(patch);
  MeshOptions options;
  // Both left out means the base's density.
  options.nodes = patch.nodes;
  options.size = patch.size;
  options.iterations = patch.iterations.value_or(base.iterations);
  options.seed = patch.seed.value_or(base.seed);
  options.inside = patch.inside.value_or(base.inside);
  options.start = patch.start.value_or(base.start);
  options.threshold = patch.threshold.value_or(base.threshold);
  options.clean_up = patch.clean_up.value_or(base.clean_up);
  return options;
}

MakeRequestPtr Maker::create(CreateCommand command, Listener listener) {
  auto request = std::make_shared<Request>();
  request->listener = std::move(listener);
  return start(request, [this, command = std::move(command)](const Run& run) {
    return prepare_create(command, run);
  });
}

MakeRequestPtr Maker::edit(EditCommand command, Listener listener) {
  auto request = std::make_shared<Request>();
  request->listener = std::move(listener);
  return start(request, [this, command = std::move(command)](const Run& run) {
    return prepare_edit(command, run);
  });
}

MakeRequestPtr Maker::start(const RequestPtr& request,
                            std::function<Prepared(const Run&)> prepare) {
  request->maker = this;
  request->self = request;
  {
    const std::scoped_lock lock(mutex_);
    requests_.insert(request);
  }
  guarded(
      [&] {
        quick_.submit(
            [this, request, prepare = std::move(prepare)] {
              const Run run = run_of(*request);
              guarded(
                  [&] {
                    run.poll();  // it may have been cancelled while it waited
                    proceed(request, prepare(run), run);
                  },
                  [&](const Error& why) { fail(request, why); });
            },
            [this, request](const Error& why) { fail(request, why); });
      },
      [&](const Error& why) { fail(request, why); });
  return request;
}

Run Maker::run_of(const Request& request) const {
  return {.stop = request.stop.get_token(),
          .on_progress = {},
          .dumps = {},
          .max_nodes = limits_.max_nodes};
}

Maker::Prepared Maker::prepare_create(const CreateCommand& command, const Run& run) const {
  Prepared prepared;
  prepared.options = first_options(command.options);
  prepared.design = command.design.empty() ? command.source.name : command.design;
  if (prepared.design.empty()) prepared.design = "model";
  check_design_name(prepared.design);
  engine_.check_node_limit(nullptr, engine_.evaluate(command.source), prepared.options, run);
  prepared.source = command.source;
  prepared.head = command.head;
  prepared.fail_on = command.fail_on;
  prepared.threads = std::clamp(command.threads, 1, limits_.threads);
  prepared.id = revision_id(prepared.source, prepared.options, "", engine_.algorithm_version);
  return prepared;
}

Maker::Prepared Maker::prepare_edit(const EditCommand& command, const Run& run) const {
  if (command.base.empty()) throw error::reference_missing("base");
  const Reference base = archive_.resolve(command.base);
  Prepared prepared;
  prepared.design = command.design.empty() ? base.design : command.design;
  if (prepared.design.empty()) {
    const auto places =
        archive_.store().read([&](Catalogue& catalogue) { return catalogue.places(base.id); });
    if (!places.empty()) prepared.design = places.front().design;
  }
  check_design_name(prepared.design);
  prepared.base = archive_.get(base.id, run);
  run.poll();  // reading the base takes a while
  const Revision& original = prepared.base->revision;
  prepared.edit = command.document;
  prepared.source = engine_.apply(original.source, command.edit);
  prepared.options = edit_options(command.options, original.options);
  engine_.check_node_limit(&original, engine_.evaluate(prepared.source), prepared.options, run);
  prepared.head = command.head;
  if (prepared.head.expected.empty()) prepared.head.expected = base.id;
  prepared.fail_on = command.fail_on;
  prepared.threads = std::clamp(command.threads, 1, limits_.threads);
  prepared.id = revision_id(prepared.source, prepared.options, base.id, engine_.algorithm_version);
  return prepared;
}

/// What can be told of a revision before it is made.
RevisionRecord Maker::record_of(const Prepared& prepared) const {
  RevisionRecord record{.id = prepared.id,
                        .root = prepared.id,
                        .model_name = prepared.source.name,
                        .model = model_digest(prepared.source),
                        .algorithm_version = engine_.algorithm_version};
  if (prepared.base) {
    record.parent = prepared.base->record.id;
    record.root = prepared.base->record.root;
  }
  return record;
}

HeldRevisionPtr Maker::find_intact(const std::string& id, const Run& run) const {
  try {
    return archive_.find(id, run);
  } catch (const Error& failure) {
    // A damaged copy in the store is made anew: the request tells everything that it takes.
    if (failure.info().kind != ErrorKind::Internal) throw;
    return nullptr;
  }
}

void Maker::proceed(const RequestPtr& request, const Prepared& prepared, const Run& run) {
  run.poll();
  request->design = prepared.design;
  request->head = prepared.head;
  request->fail_on = prepared.fail_on;
  // Before anything is computed, where it can be told by now.
  if (prepared.head.require || !prepared.fail_on.empty())
    archive_.check_filing(record_of(prepared), prepared.design, prepared.head, prepared.fail_on);
  if (const auto revision = find_intact(prepared.id, run)) {
    hand_out(request, revision, true);
  } else {
    launch(request, prepared);
  }
}

void Maker::launch(const RequestPtr& request, const Prepared& prepared) {
  if (!request->answered) report(request->listener, {.stage = "queued"});
  bool late = false;
  {
    const std::scoped_lock lock(mutex_);
    if (stopped_) throw error::shutting_down();
    if (request->answered) return;
    const auto under_way = computing_.find(prepared.id);
    if (under_way != computing_.end()) {
      under_way->second->requests.push_back(request);
      request->joined = under_way->second;
    } else if (archive_.held().contains(prepared.id)) {
      // It was finished between the look into the archive and this one.
      late = true;
    } else {
      archive_.check_room();
      auto computation = std::make_shared<Computation>();
      computation->prepared = prepared;
      computation->requests.push_back(request);
      computation->job = workers_.submit([this, computation] { compute(computation); },
                                         [this, computation](const Error& why) {
                                           for (const RequestPtr& waiting : retire(computation))
                                             fail(waiting, why);
                                         });
      request->joined = computation;
      computing_.emplace(prepared.id, computation);
    }
  }
  if (late) {
    if (const auto revision = find_intact(prepared.id, run_of(*request)))
      return hand_out(request, revision, true);
    return launch(request, prepared);
  }
}

void Maker::compute(const ComputationPtr& computation) {
  const Prepared& prepared = computation->prepared;
  const Run run{.stop = computation->stop.get_token(),
                .on_progress =
                    [&](const Progress& progress) {
                      std::vector<RequestPtr> listening;
                      {
                        const std::scoped_lock lock(mutex_);
                        listening = computation->requests;
                      }
                      for (const RequestPtr& request : listening)
                        if (!request->answered) report(request->listener, progress);
                    },
                .threads = prepared.threads,
                .dumps = limits_.dumps.empty() ? limits_.dumps : limits_.dumps / prepared.id,
                .max_nodes = limits_.max_nodes};
  guarded(
      [&] {
        run.poll();
        auto made = std::make_shared<HeldRevision>();
        made->revision = engine_.make_revision(prepared.base ? &prepared.base->revision : nullptr,
                                               prepared.source, prepared.options, run);
        run.poll();
        Revision& revision = made->revision;
        revision.report.revision = prepared.id;
        revision.report.cached = false;
        made->edit = prepared.edit;
        made->asked = prepared.options;
        made->record = record_of(prepared);
        made->record.created_ns = nanoseconds_now();
        made->record.nodes = static_cast<std::uint32_t>(revision.delivery.mesh.nodes.size());
        made->record.tets = static_cast<std::uint32_t>(revision.delivery.mesh.tets.size());
        // In memory before it leaves the list, so that no moment is left to compute it twice.
        archive_.hold(made);
        bool first = true;
        for (const RequestPtr& request : retire(computation)) {
          hand_out(request, made, !first);
          first = false;
        }
        archive_.drop_unfiled(prepared.id);
      },
      [&](const Error& why) {
        for (const RequestPtr& request : retire(computation)) fail(request, why);
      });
}

void Maker::hand_out(const RequestPtr& request, const HeldRevisionPtr& revision, bool cached) {
  if (request->answered) return;
  guarded(
      [&] {
        check_warnings(revision->revision.report.warnings, request->fail_on);
        Made made{.revision = revision, .cached = cached};
        made.filed = archive_.file(revision, request->design, request->head, request->fail_on);
        if (made.filed.head_kept) made.warnings.push_back(*made.filed.head_kept);
        if (!close(request)) return;
        const Listener& listener = request->listener;
        // It is answered: `fail` would do nothing any more.
        guarded([&] { listener.made(made); },
                [&](const Error& why) { contained([&] { listener.failed(why); }); });
      },
      [&](const Error& why) { fail(request, why); });
}

std::vector<Maker::RequestPtr> Maker::retire(const ComputationPtr& computation) {
  const std::scoped_lock lock(mutex_);
  const auto entry = computing_.find(computation->prepared.id);
  if (entry != computing_.end() && entry->second == computation) computing_.erase(entry);
  return std::exchange(computation->requests, {});
}

void Maker::leave(const RequestPtr& request) {
  const std::scoped_lock lock(mutex_);
  requests_.erase(request);
  const ComputationPtr computation = request->joined.lock();
  if (!computation) return;
  auto& waiting = computation->requests;
  const auto place = std::find(waiting.begin(), waiting.end(), request);
  if (place == waiting.end()) return;
  waiting.erase(place);
  if (!waiting.empty()) return;
  // Nobody waits any more: a request for the same revision from now on starts afresh.
  computation->stop.request_stop();
  workers_.withdraw(computation->job);
  const auto entry = computing_.find(computation->prepared.id);
  if (entry != computing_.end() && entry->second == computation) computing_.erase(entry);
}

/// Marks a request as answered; false if it was.
bool Maker::close(const RequestPtr& request) {
  if (request->answered.exchange(true)) return false;
  leave(request);
  return true;
}

void Maker::fail(const RequestPtr& request, const Error& why) {
  if (close(request)) contained([&] { request->listener.failed(why); });
}

std::size_t Maker::waiting() const {
  const std::scoped_lock lock(mutex_);
  std::size_t waiting = 0;
  for (const auto& [id, computation] : computing_) waiting += computation->requests.size();
  return waiting;
}

void Maker::stop() {
  std::set<RequestPtr> requests;
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
    requests = requests_;
  }
  for (const RequestPtr& request : requests) {
    request->stop.request_stop();
    fail(request, error::shutting_down());
  }
}

}  // namespace remeshd
