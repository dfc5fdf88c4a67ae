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
    int threads = 1;                    ///< at most, for one computation
    std::uint32_t max_nodes = 5000000;  ///< that may be asked for
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

  /// Never throws; what is wrong goes to the listener, maybe before these return.
  MakeRequestPtr create(CreateCommand command, Listener listener);
  MakeRequestPtr edit(EditCommand command, Listener listener);

  /// Ends every request with Unavailable and asks the computations to stop.
  void stop();

  /// Options of a first mesh; throws Error(`OptionsInvalid`, `MeshTooLarge`).
  [[nodiscard]] MeshOptions first_options(const OptionsPatch& patch) const;
  /// Options of an edit of a revision that has `base`.
  [[nodiscard]] MeshOptions edit_options(const OptionsPatch& patch, const MeshOptions& base) const;

 private:
  struct Computation;
  struct Request;
  struct Prepared;
  using RequestPtr = std::shared_ptr<Request>;
  using ComputationPtr = std::shared_ptr<Computation>;

  MakeRequestPtr start(const RequestPtr& request, std::function<Prepared(const Run&)> prepare);
  Prepared prepare_create(const CreateCommand& command) const;
  Prepared prepare_edit(const EditCommand& command, const Run& run) const;
  void proceed(const RequestPtr& request, const Prepared& prepared, const Run& run);
  HeldRevisionPtr find_or_mend(const std::string& id, bool& damaged, const Run& run) const;
  void launch(const RequestPtr& request, const Prepared& prepared, bool damaged);
  void compute(const ComputationPtr& computation);
  void hand_out(const RequestPtr& request, const HeldRevisionPtr& revision, bool cached,
                bool rewrite);
  std::vector<RequestPtr> retire(const ComputationPtr& computation);
  void leave(const RequestPtr& request);
  void finish(const RequestPtr& request, const std::function<void(const Listener&)>& tell);
  void fail(const RequestPtr& request, const Error& why);

  const Engine& engine_;
  Archive& archive_;
  Pool& quick_;
  Pool& workers_;
  const Limits limits_;

  std::mutex mutex_;
  bool stopped_ = false;
  std::map<std::string, ComputationPtr> computing_;  ///< by id
  std::set<RequestPtr> requests_;                    ///< not answered yet
};

}  // namespace remeshd
