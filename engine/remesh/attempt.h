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

/// What every strategy starts from: the model to be meshed and the revision that it was edited
/// from. What several strategies need is made when the first of them asks. Keeps references.
class Problem {
 public:
  /// `edited`: `Revision::none()` for a first mesh; `to_mesh`: with its model, cells and options.
  Problem(const Revision& edited, const Revision& to_mesh, const Density& target, const Run& around)
      : parent(edited), modified(to_mesh), density(target), run(around) {}

  const Revision& parent;
  const Revision& modified;
  const Density density;
  const Run& run;

  /// Copycells and newcells of the modified model (Sect. 5). New too is what the parent has nodes
  /// in that were made for other edge lengths (`resized`).
  [[nodiscard]] const CopyPlan& plan() const;
  [[nodiscard]] bool is_resized() const;  ///< whether there are such nodes
  /// Where rims of groups have come or gone, new too: points on them, near each other.
  [[nodiscard]] const std::vector<Vec3>& changed_rims() const;
  /// Where the entities of the parent's boundary are in the modified one.
  [[nodiscard]] const EntityMap& entities() const;
  /// Whether there are features that nodes may be copied of.
  [[nodiscard]] bool copies() const { return plan().copies(); }

 private:
  mutable std::unique_ptr<const CopyPlan> plan_;
  mutable bool is_resized_ = false;
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
  std::vector<Vec3> refined_at;  ///< where its edges were to be finer
  bool too_fine = false;  ///< the boundary would need many more nodes than the edge length says
  bool hopeless = false;  ///< another one that is so too, and no mesh is to be had
  bool copies = false;    ///< its nodes may be copies of the parent's
  bool serves = true;     ///< false: the problem is none for this strategy, or too large for it

  // What the report gets of it.
  PhaseSeconds seconds;  ///< `total` of all of it
  Counts counts;
  double free_share = 1;
  std::vector<Warning> warnings;
  std::vector<TriedStrategy> tries;  ///< given up on the way to it
  double last_resort_share = 0;      ///< of the tets: those made anew where a mesh was wrong

  [[nodiscard]] bool taken() const { return serves && reason.empty(); }
  /// Where its mesh was found to be wrong.
  [[nodiscard]] std::vector<Vec3> faulty_places() const;
  [[nodiscard]] const Candidate* candidate() const { return std::get_if<Candidate>(&mesh); }
};

/// Where a mesh was found to be wrong.
std::vector<Vec3> faulty_places(const Verification& verification);

/// What is made anew round faulty places: some edge lengths about them.
Region region_of(std::span<const Vec3> faulty_places, const SizeField& sizes);

/// Of the tets of an attempt's mesh those that are new and have their centroids in a region.
double share_in(const Region& region, const Attempt& attempt);

/// Each with its reason, as an Error has them: `full: an inverted tet at (1, 2, 3)`.
std::vector<std::string> in_words(std::span<const TriedStrategy> tried);

/// Adds the seconds of each phase.
void add(PhaseSeconds& sum, const PhaseSeconds& more);

/// What is wrong with a mesh of the modified model, and where.
Warning describe_fault(const Candidate& failed, const Problem& problem);

}  // namespace remeshd
