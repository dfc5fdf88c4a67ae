#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "server/session/archive.h"
#include "server/session/commands.h"
#include "server/session/engine.h"
#include "server/session/pool.h"

namespace remeshd {

/// A command on its way.
class MakeRequest {
 public:
  virtual ~MakeRequest() = default;
  /// Answers the request with Cancelled at once, unless it is answered already. The computation
  /// stops if nobody else waits for it.
  virtual void cancel() = 0;
};
using MakeRequestPtr = std::shared_ptr<MakeRequest>;

/// Makes revisions. A command is prepared (base read, edit applied, model validated, id found) by a
/// quick pool; a revision that exists is handed out, one on its way is waited for together, and any
/// other is computed by the pool of workers.
///
/// Inv: of one id at most one computation is under way that somebody waits for.
class Maker {
 public:
  struct Limits {
    int threads = 1;                             ///< at most, for one computation
    std::uint32_t max_nodes = kDefaultMaxNodes;  ///< as Run::max_nodes
    /// Folder in which a computation leaves its stages, in one of its own by its revision's id;
    /// empty: none.
    std::filesystem::path dumps;
  };

  /// Everything referred to must outlive the maker.
  Maker(const Engine& engine, Archive& archive, Pool& quick, Pool& workers, Limits limits);
  /// As `stop`.
  ~Maker();
  Maker(const Maker&) = delete;
  Maker& operator=(const Maker&) = delete;

  /// Never throws; what is wrong goes to the listener, maybe before these return. A listener that
  /// throws from `made` hears `failed` next; what it throws from the others is dropped.
  MakeRequestPtr create(CreateCommand command, Listener listener);
  MakeRequestPtr edit(EditCommand command, Listener listener);

  /// Ends every request with Unavailable and asks the computations to stop.
  void stop();

  /// Requests that wait for a computation.
  [[nodiscard]] std::size_t waiting() const;

  /// Options of a first mesh; throws Error(`OPTIONS_INVALID`).
  [[nodiscard]] static MeshOptions first_options(const OptionsPatch& patch);
  /// Options of an edit of a revision that has `base`; throws Error(`OPTIONS_INVALID`).
  [[nodiscard]] static MeshOptions edit_options(const OptionsPatch& patch, const MeshOptions& base);

 private:
  struct Computation;
  struct Request;
  struct Prepared;
  using RequestPtr = std::shared_ptr<Request>;
  using ComputationPtr = std::shared_ptr<Computation>;

  MakeRequestPtr start(const RequestPtr& request, std::function<Prepared(const Run&)> prepare);
  Prepared prepare_create(const CreateCommand& command, const Run& run) const;
  Prepared prepare_edit(const EditCommand& command, const Run& run) const;
  [[nodiscard]] RevisionRecord record_of(const Prepared& prepared) const;
  [[nodiscard]] Run run_of(const Request& request) const;
  void proceed(const RequestPtr& request, const Prepared& prepared, const Run& run);
  HeldRevisionPtr find_intact(const std::string& id, const Run& run) const;
  void launch(const RequestPtr& request, const Prepared& prepared);
  void compute(const ComputationPtr& computation);
  void hand_out(const RequestPtr& request, const HeldRevisionPtr& revision, bool cached);
  std::vector<RequestPtr> retire(const ComputationPtr& computation);
  void leave(const RequestPtr& request);
  bool close(const RequestPtr& request);
  void fail(const RequestPtr& request, const Error& why);

  const Engine& engine_;
  Archive& archive_;
  Pool& quick_;
  Pool& workers_;
  const Limits limits_;

  mutable std::mutex mutex_;
  bool stopped_ = false;
  std::map<std::string, ComputationPtr> computing_;  ///< by id
  std::set<RequestPtr> requests_;                    ///< not answered yet
};

}  // namespace remeshd
