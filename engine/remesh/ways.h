#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "engine/remesh/stages.h"
#include "engine/remesh/stopwatch.h"
#include "engine/remesh/trial.h"

namespace remeshd {

/// A mesh with what its nodes were copied from.
struct NewMesh {
  Candidate candidate;
  const Revision* copied_from = nullptr;  ///< null where every node is new
  std::shared_ptr<const PointSource> source;
};

/// The ways to a mesh where there is none that could be kept: Local, Full, Fresh and TetGen of
/// `Way`. What is done goes into the report, the time into its phases; so does what was given up.
class Ways {
 public:
  /// Keeps references; `revision` has its model and cells. `original`: null for a first mesh.
  Ways(const Revision* original, Revision& revision, const Density& density, Stopwatch& watch,
       const Run& run);

  /// The first valid mesh: with the nodes that the plan copies, failing that with all of them free,
  /// failing that from new nodes, failing that by TetGen. A boundary with details far finer than
  /// the edge length, told by the nodes that its repair takes, goes to TetGen at once unless they
  /// made it valid: placing nodes anew would be in vain. Where the original's boundary took so
  /// many, not all of them are freed.
  ///
  /// Throws Error(BOUNDARY_NOT_RECOVERED) where TetGen fails too.
  NewMesh first_valid();

  /// From new nodes throughout; may be invalid. `strategy`: its name among the attempts.
  NewMesh regular(std::uint64_t seed, const char* strategy);

  /// The strategy tried last, as an attempt that is given up now for this reason.
  [[nodiscard]] Attempt last_given_up(std::string reason) const;
  /// What is wrong with a mesh that is not valid.
  [[nodiscard]] std::string fault_of(const NewMesh& made) const;

 private:
  /// What one try at a mesh works with.
  struct Setting {
    std::string strategy;  ///< where it works everywhere
    Target target;
    Density density;
    std::uint64_t seed;
    bool all_free;  ///< optimise the copied nodes too, all of them
  };

  NewMesh begin(const Revision* copied_from);
  Candidate attempt(const Setting& s);
  std::variant<Candidate, std::string> attempt_in_part(const Setting& s, const Reach& reach,
                                                       bool largest);
  std::optional<Candidate> attempt_within(const Setting& s, const Reach& reach);
  std::uint32_t finish_repaired(Candidate& c, const Setting& s, const Site& site,
                                const Samples& samples, const InsideTest& inside);
  std::shared_ptr<const PointSource> points_of(const Revision* original);
  [[nodiscard]] Warning describe_failure(const Candidate& failed, const PointSource& source) const;
  void next(Way way, const NewMesh& failed, const char* what);

  const Revision* original_;
  Revision& revision_;
  Density density_;
  Stopwatch& watch_;
  const Run& run_;
  std::optional<Trial> trial_;  ///< the last
};

}  // namespace remeshd
