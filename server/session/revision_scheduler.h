#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "server/admission/admission.h"
#include "server/admission/memory_budget.h"
#include "server/admission/pool.h"
#include "server/session/archive.h"
#include "server/session/commands.h"
#include "server/session/computations.h"
#include "server/session/engine.h"
#include "server/session/fetcher.h"
#include "server/session/make_request.h"
#include "server/session/preparation.h"

namespace remeshd {

/// Makes revisions. A command is read and prepared (base fetched, edit applied, model validated, id
/// found) in the lane of preparations; a revision that exists is handed out, one on its way is
/// waited for together, and any other is computed in the lane of computations, with a share of the
/// memory budget for as long.
class RevisionScheduler {
 public:
  struct Limits {
    int threads = 1;                             ///< at most, for one computation
    std::uint32_t max_nodes = kDefaultMaxNodes;  ///< as Run::max_nodes
    /// Folder in which a computation leaves its stages, in one of its own by its revision's id;
    /// empty: none.
    std::filesystem::path dumps;
  };
  /// What it works on and with; must outlive it.
  struct Parts {
    const Engine& engine;
    Archive& archive;
    Fetcher& fetcher;
    MemoryBudget& memory;
    Pool& preparation;
    Pool& computation;
  };

  RevisionScheduler(Parts parts, Limits limits);
  /// As `stop`.
  ~RevisionScheduler();
  RevisionScheduler(const RevisionScheduler&) = delete;
  RevisionScheduler& operator=(const RevisionScheduler&) = delete;

  /// `read` gives the command; it is called in the lane of preparations and may throw Error.
  ///
  /// Never throws; what is wrong goes to the listener, maybe before this returns. A listener that
  /// throws from `made` hears `failed` next; what it throws from the others is dropped.
  MakeRequestPtr make(Admission::TicketPtr ticket, std::function<Command()> read,
                      Listener listener);

  /// Ends every request with Unavailable and asks the computations to stop.
  void stop();

  /// Requests that wait for a computation.
  [[nodiscard]] std::size_t waiting() const { return computations_.waiting(); }

 private:
  using Clock = FairQueue::Clock;

  void begin(const WaitingRequestPtr& request, const Admission::TicketPtr& ticket,
             const std::function<Command()>& read);
  void prepare(const WaitingRequestPtr& request, const Command& command,
               const std::optional<EditBase>& base, const HeldRevisionPtr& revision);
  void proceed(const WaitingRequestPtr& request, const Prepared& prepared);
  HeldRevisionPtr find_intact(const std::string& id, const std::stop_token& stop) const;
  void compute(const ComputationPtr& computation);
  /// The result of a computation.
  struct Outcome {
    HeldRevisionPtr revision;
    bool computed = true;  ///< else it came from the shared tier
  };
  Outcome outcome_of(const ComputationPtr& computation);
  HeldRevisionPtr make_revision(const ComputationPtr& computation, const std::stop_token& stop);
  void check_waiting(const ComputationPtr& computation, std::span<const Warning> warnings);
  void complete(const WaitingRequestPtr& request, const HeldRevisionPtr& revision, bool cached);
  bool close(const WaitingRequestPtr& request);
  void fail(const WaitingRequestPtr& request, const Error& why);

  const Parts parts_;
  const Limits limits_;
  const Preparation preparation_;
  Computations computations_;

  std::mutex mutex_;
  bool stopped_ = false;
  std::set<WaitingRequestPtr> requests_;  ///< not answered yet
};

}  // namespace remeshd
