#include "server/session/revision_scheduler.h"

#include <algorithm>
#include <utility>

#include "server/limits.h"
#include "server/session/catching.h"
#include "server/session/clock.h"
#include "server/session/fail_on.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

/// Bytes that a computation needs at its peak, beside its base.
std::uint64_t working_memory(const Prepared& prepared) {
  double nodes = prepared.nodes;
  if (prepared.base) nodes = std::max(nodes, 1.0 * prepared.base->record.nodes);
  return static_cast<std::uint64_t>(limits::kBytesPerNode * nodes);
}

}  // namespace

RevisionScheduler::RevisionScheduler(Parts parts, Limits limits)
    : parts_(parts),
      limits_(std::move(limits)),
      preparation_(parts.engine, parts.archive, limits_.threads, limits_.max_nodes),
      computations_(
          parts.computation,
          {.compute = [this](const ComputationPtr& work) { compute(work); },
           .failed =
               [this](const ComputationPtr& work, const Error& why) {
                 for (const auto& request : computations_.remove(work)) fail(request, why);
               },
           .is_made =
               [this](const std::string& id) { return parts_.archive.held().contains(id); }}) {}

RevisionScheduler::~RevisionScheduler() { stop(); }

MakeRequestPtr RevisionScheduler::make(Admission::TicketPtr ticket, std::function<Command()> read,
                                       Listener listener) {
  const auto cancel = [this](const WaitingRequestPtr& request) {
    request->stop().request_stop();
    fail(request, error::cancelled());
  };
  auto request = std::make_shared<WaitingRequest>(ticket->tenant(), std::move(listener), cancel);
  catching(
      [&] {
        {
          const std::scoped_lock lock(mutex_);
          if (stopped_) throw error::shutting_down();
          requests_.insert(request);
        }
        parts_.preparation.submit(
            {.tenant = request->tenant(),
             .run = [this, request, ticket = std::move(ticket),
                     read = std::move(read)] { begin(request, ticket, read); },
             .refused = [this, request](const Error& why) { fail(request, why); }});
      },
      [&](const Error& why) { fail(request, why); });
  return request;
}

/// The ticket is held until the request is prepared, also while its base is made again.
void RevisionScheduler::begin(const WaitingRequestPtr& request, const Admission::TicketPtr& ticket,
                              const std::function<Command()>& read) {
  catching(
      [&] {
        if (request->answered()) return;  // cancelled while it waited
        const auto command = std::make_shared<const Command>(read());
        const std::optional<EditBase> base = preparation_.base_of(*command);
        if (!base) return prepare(request, *command, base, nullptr);
        parts_.fetcher.fetch(
            base->id, request->stop().get_token(),
            {.got =
                 [this, request, ticket, command, base](const HeldRevisionPtr& revision) {
                   prepare(request, *command, base, revision);
                 },
             .failed = [this, request](const Error& why) { fail(request, why); }});
      },
      [&](const Error& why) { fail(request, why); });
}

void RevisionScheduler::prepare(const WaitingRequestPtr& request, const Command& command,
                                const std::optional<EditBase>& base,
                                const HeldRevisionPtr& revision) {
  const Prepared prepared =
      preparation_.prepare(command, base, revision, request->stop().get_token());
  request->design = prepared.design;
  request->head = prepared.head;
  request->fail_on = prepared.fail_on;
  // Before anything is computed, where it can be told by now.
  if (prepared.head.require || !prepared.fail_on.empty())
    parts_.archive.check_filing(preparation_.record_of(prepared), prepared.design, prepared.head,
                                prepared.fail_on);
  proceed(request, prepared);
}

HeldRevisionPtr RevisionScheduler::find_intact(const std::string& id,
                                               const std::stop_token& stop) const {
  try {
    return parts_.archive.find(id, Run{.stop = stop, .on_progress = {}, .dumps = {}});
  } catch (const Error& failure) {
    // A damaged copy in the store is made anew: the request has all that this needs.
    if (failure.info().kind != ErrorKind::Internal) throw;
    return nullptr;
  }
}

void RevisionScheduler::proceed(const WaitingRequestPtr& request, const Prepared& prepared) {
  while (!request->answered()) {
    if (const auto revision = find_intact(prepared.id, request->stop().get_token()))
      return complete(request, revision, true);
    parts_.archive.check_room(working_memory(prepared));
    request->report({.stage = "queued"});
    // Where it was made since the look into the archive: look again, for it may be dropped by then.
    if (computations_.enter(request, prepared) != Computations::Entry::IsMade) return;
  }
}

/// The shared tier is asked for the mesh while it is computed; what comes first is taken.
RevisionScheduler::Outcome RevisionScheduler::outcome_of(const ComputationPtr& computation) {
  const std::stop_token asked = computation->stop.get_token();
  if (!parts_.archive.shares()) return {make_revision(computation, asked)};
  HeldRevisionPtr shared;
  std::stop_source either;
  const std::stop_callback forward(asked, [&] { either.request_stop(); });
  std::jthread look_up([&](const std::stop_token& stop) {  // requested at the end of this function
    contained([&] {
      shared = parts_.archive.find_shared(computation->prepared.id,
                                          Run{.stop = stop, .on_progress = {}, .dumps = {}});
      if (shared) either.request_stop();
    });
  });
  try {
    return {make_revision(computation, either.get_token())};
  } catch (const Error& failure) {
    if (failure.info().kind != ErrorKind::Cancelled) throw;
    look_up.join();
    if (!shared || asked.stop_requested()) throw;
    return {shared, false};
  }
}

HeldRevisionPtr RevisionScheduler::make_revision(const ComputationPtr& computation,
                                                 const std::stop_token& stop) {
  const Prepared& prepared = computation->prepared;
  const Run run{.stop = stop,
                .on_progress =
                    [&, furthest = 0.0](Progress progress) mutable {
                      // Another attempt at a mesh begins with less again.
                      progress.fraction = furthest = std::max(furthest, progress.fraction);
                      for (const auto& request : computations_.waiting_for(computation))
                        request->report(progress);
                    },
                .threads = prepared.threads,
                .dumps = limits_.dumps.empty() ? limits_.dumps : limits_.dumps / prepared.id,
                .max_nodes = limits_.max_nodes,
                .on_warnings = [&](auto warnings) { check_waiting(computation, warnings); }};
  run.poll();  // it may have been stopped while it waited for memory
  const auto start = Clock::now();
  auto made = std::make_shared<HeldRevision>();
  made->revision = parts_.engine.make_revision(prepared.base ? &prepared.base->revision : nullptr,
                                               prepared.source, prepared.options, run);
  run.poll();
  parts_.computation.took(std::chrono::duration<double>(Clock::now() - start).count());
  Revision& revision = made->revision;
  revision.report.revision = prepared.id;
  revision.report.cached = false;
  made->edit = prepared.edit;
  made->asked = prepared.options;
  made->record = preparation_.record_of(prepared);
  made->record.created_ns = nanoseconds_now();
  made->record.nodes = static_cast<std::uint32_t>(revision.output.mesh.nodes.size());
  made->record.tets = static_cast<std::uint32_t>(revision.output.mesh.tets.size());
  made->record.mid_nodes = static_cast<std::uint32_t>(revision.output.mids.positions.size());
  return made;
}

/// Ends the requests that take one of these warnings for an error. The computation goes on as long
/// as others wait for it.
void RevisionScheduler::check_waiting(const ComputationPtr& computation,
                                      std::span<const Warning> warnings) {
  for (const auto& request : computations_.waiting_for(computation))
    catching([&] { check_warnings(warnings, request->fail_on); },
             [&](const Error& why) { fail(request, why); });
}

void RevisionScheduler::compute(const ComputationPtr& computation) {
  catching(
      [&] {
        // Held until the revision is filed: writing it takes memory too.
        const auto share =
            parts_.memory.take(working_memory(computation->prepared), computation->stop.get_token(),
                               parts_.computation.limits().wait);
        const auto [made, computed] = outcome_of(computation);
        // In memory before it leaves the list, so that at no moment another request computes it
        // again.
        parts_.archive.hold(made);
        bool cached = !computed;
        for (const auto& request : computations_.remove(computation)) {
          complete(request, made, cached);
          cached = true;
        }
        parts_.archive.drop_unfiled(made->record.id);
      },
      [&](const Error& why) {
        for (const auto& request : computations_.remove(computation)) fail(request, why);
      });
}

void RevisionScheduler::complete(const WaitingRequestPtr& request, const HeldRevisionPtr& revision,
                                 bool cached) {
  if (request->answered()) return;
  catching(
      [&] {
        check_warnings(revision->revision.report.warnings, request->fail_on);
        Made made{.revision = revision, .cached = cached};
        made.filed =
            parts_.archive.file(revision, request->design, request->head, request->fail_on);
        made.warnings = made.filed.warnings;
        parts_.archive.publish(revision->record.id);
        if (!close(request)) return;
        const Listener& listener = request->listener();
        // It is answered: `fail` would do nothing any more.
        catching([&] { listener.made(made); },
                 [&](const Error& why) { contained([&] { listener.failed(why); }); });
      },
      [&](const Error& why) { fail(request, why); });
}

/// Marks a request as answered; false if it was already.
bool RevisionScheduler::close(const WaitingRequestPtr& request) {
  if (!request->close()) return false;
  {
    const std::scoped_lock lock(mutex_);
    requests_.erase(request);
  }
  computations_.leave(request);
  return true;
}

void RevisionScheduler::fail(const WaitingRequestPtr& request, const Error& why) {
  if (close(request)) contained([&] { request->listener().failed(why); });
}

void RevisionScheduler::stop() {
  std::set<WaitingRequestPtr> requests;
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
    requests = requests_;
  }
  for (const auto& request : requests) {
    request->stop().request_stop();
    fail(request, error::shutting_down());
  }
}

}  // namespace remeshd
