#pragma once

#include <memory>
#include <optional>

#include "engine/remesh/stages.h"
#include "engine/remesh/stopwatch.h"

namespace remeshd {

/// A mesh with what its nodes were copied from.
struct NewMesh {
  Candidate candidate;
  const Revision* copied_from = nullptr;  ///< null where every node is new
  std::shared_ptr<const PointSource> source;
};

/// The ways to a mesh where there is none that could be kept: Local, Full, Fresh and TetGen of
/// `Way`. What is done goes into the report, the time into its phases.
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

  /// From new nodes throughout; may be invalid.
  NewMesh regular(std::uint64_t seed);

 private:
  /// What one try at a mesh works with.
  struct Setting {
    Target target;
    Density density;
    std::uint64_t seed;
    bool all_free;  ///< optimise the copied nodes too, all of them
  };

  NewMesh begin(const Revision* copied_from);
  Candidate attempt(const Setting& s);
  std::optional<Candidate> attempt_within(const Setting& s, const Reach& reach);
  std::uint32_t finish_repaired(Candidate& c, const Setting& s, const Site& site,
                                const Samples& samples, const InsideTest& inside);
  std::shared_ptr<const PointSource> points_of(const Revision* original);
  void next(Way way, const NewMesh& failed, const char* what);

  const Revision* original_;
  Revision& revision_;
  Density density_;
  Stopwatch& watch_;
  const Run& run_;
};

}  // namespace remeshd
