#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/stopwatch.h"
#include "engine/base/warning.h"
#include "engine/boundary/entity_map.h"
#include "engine/patch/candidate.h"
#include "engine/plan/copy_plan.h"
#include "engine/remesh/density.h"
#include "engine/remesh/morph/morph.h"
#include "engine/revision/report.h"

namespace remeshd {

/// What every strategy starts from: the model to be meshed and the parent, the revision that was
/// edited. What several strategies need is made when the first of them asks. Keeps references.
class Problem {
 public:
  /// `edited`: the parent, `Revision::none()` for a first mesh; `to_mesh`: the revision to be
  /// meshed, with its model, cells and options already.
  Problem(const Revision& edited, const Revision& to_mesh, const Density& target, const Run& around)
      : parent(edited), modified(to_mesh), density(target), run(around) {}

  const Revision& parent;
  const Revision& modified;
  const Density density;
  const Run& run;

  /// Copycells and newcells of the modified model (Sect. 5). Material whose nodes in the parent
  /// were made for other edge lengths (`resized`) is new too, and so is that at `changed_rims`.
  [[nodiscard]] const CopyPlan& plan() const;
  /// The greatest ratio, at least 1, between the edge length that such a node was made for and the
  /// one wanted there; 1 where there are no such nodes.
  [[nodiscard]] double most_off() const;
  /// Closely spaced points on those rims of groups that only the parent's boundary or only the
  /// modified one has.
  [[nodiscard]] const std::vector<Vec3>& changed_rims() const;
  /// Where the entities of the parent's boundary are in the modified one.
  [[nodiscard]] const EntityMap& entities() const;
  /// Whether the parent has features, whose nodes may be copied.
  [[nodiscard]] bool copies() const { return plan().copies(); }

 private:
  mutable std::unique_ptr<const CopyPlan> plan_;
  mutable double most_off_ = 1;
  mutable std::optional<std::vector<Vec3>> changed_rims_;
  mutable std::unique_ptr<const EntityMap> entities_;
};

/// The plan of a mesh all of whose nodes are new.
std::unique_ptr<const CopyPlan> plan_of_nothing(const Problem& problem);

/// A try at a mesh by one strategy: a mesh that is taken, or why it is not, with all that there is
/// to tell of it.
struct Attempt {
  explicit Attempt(std::string strategy) : name(std::move(strategy)) {}

  std::string name;  ///< of the strategy, as the report lists it: `local, 4 edge lengths`
  /// The parent's own mesh, its nodes moved, or a new one.
  std::variant<std::monostate, MorphedMesh, Candidate> mesh;
  std::string reason;            ///< why it was not taken; empty where it is
  std::optional<Warning> fault;  ///< what is wrong with the mesh, and where
  std::vector<Vec3> refined_at;  ///< where it was to have shorter edges
  bool too_fine = false;  ///< the boundary would need many more nodes than the edge length says
  bool hopeless = false;  ///< two such attempts in a row end the request: no mesh is to be had
  bool copies = false;    ///< its nodes may be copies of the parent's
  bool serves = true;     ///< false: the problem does not suit the strategy, or is too large for it

  // What the report gets of it.
  PhaseSeconds seconds;  ///< `total`: of the whole attempt
  Counts counts;
  double free_share = 1;
  std::vector<Warning> warnings;
  std::vector<TriedStrategy> tries;  ///< tries within this attempt that were given up
  double last_resort_share = 0;      ///< share of tets that were made anew where a mesh was wrong

  [[nodiscard]] bool taken() const { return serves && reason.empty(); }
  /// Where its mesh was found to be wrong.
  [[nodiscard]] std::vector<Vec3> faulty_places() const;
  /// Of the whole attempt, but without its tries.
  [[nodiscard]] double seconds_of_its_own() const;
  [[nodiscard]] const Candidate* candidate() const { return std::get_if<Candidate>(&mesh); }
};

/// Where a mesh was found to be wrong; defects of the mesh as a whole have no place.
std::vector<Vec3> faulty_places(const Verification& verification);

/// The region that is made anew round faulty places: 2.5 edge lengths about each, by the longest
/// edge length at any of them.
Region region_of(std::span<const Vec3> faulty_places, const SizeField& sizes);

/// Share of the tets of an attempt's mesh that are new and have their centroids in the region.
/// Pre: the attempt's mesh is a candidate.
double share_in(const Region& region, const Attempt& attempt);

/// Each attempt with its reason, as an Error lists them: `full: an inverted tet at (1, 2, 3)`.
std::vector<std::string> in_words(std::span<const TriedStrategy> tried);

/// Adds the seconds of each phase, but not the total.
void add(PhaseSeconds& sum, const PhaseSeconds& more);

/// What is wrong with a mesh of the modified model, and where.
Warning describe_fault(const Candidate& failed, const Problem& problem);

}  // namespace remeshd
