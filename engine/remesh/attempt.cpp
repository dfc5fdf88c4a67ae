#include "engine/remesh/attempt.h"

#include <cmath>
#include <utility>

#include "engine/base/region.h"
#include "engine/base/tolerance.h"
#include "engine/cellular/boundary_model/group_rims.h"
#include "engine/delivery/failure_place.h"
#include "engine/nodes/nearest.h"
#include "engine/remesh/node_sizes.h"

namespace remeshd {

namespace {
struct AnewLimits {
  double margin = 2.5;       ///< x edge length: how far round a faulty place all is made anew
  int steps = 2;             ///< cubes of the Region along the margin
  double rim_spacing = 0.5;  ///< x edge length: largest distance of points along changed rims
};
constexpr AnewLimits kAnewLimits;

/// The plan, but material within an edge length of one of the places is new where it would be
/// copied in place. The places are spaced closely, along rims.
CopyPlan with_new_at(const CopyPlan& plan, std::span<const Vec3> places, const SizeField& sizes) {
  double longest = 0;
  for (const Vec3& p : places) longest = std::fmax(longest, sizes(p));
  const auto near = std::make_shared<const NearestNode>(places, kGridCell * longest);
  return plan.with_new_where(
      [near, sizes, in_place = plan.identity()](const Vec3& p, std::int32_t t) {
        return t == in_place && near->any_within(p, sizes(p));
      },
      Region(places, longest, 1).boxes());
}
}  // namespace

const CopyPlan& Problem::plan() const {
  if (!plan_) {
    CopyPlan plan(parent.copied_model(), modified.model,
                  copy_lengths(density.sizes.base(), density.sizes.even()), run);
    if (auto anew = resized(plan, parent, modified, density.sizes, run)) {
      plan = std::move(anew->plan);
      most_off_ = anew->most_off;
    }
    if (!changed_rims().empty() && plan.copies())
      plan = with_new_at(plan, changed_rims(), density.sizes);
    plan_ = std::make_unique<const CopyPlan>(std::move(plan));
  }
  return *plan_;
}

const std::vector<Vec3>& Problem::changed_rims() const {
  if (!changed_rims_) {
    const bool none = parent.model.groups == modified.model.groups && parent.model.groups.empty();
    const auto apart = [&](const Vec3& p) { return kAnewLimits.rim_spacing * density.sizes(p); };
    changed_rims_ =
        none ? std::vector<Vec3>{}
             : remeshd::changed_rims(parent.cells.boundary, modified.cells.boundary, apart);
  }
  return *changed_rims_;
}

double Problem::most_off() const {
  static_cast<void>(plan());
  return most_off_;
}

const EntityMap& Problem::entities() const {
  const BoundaryModel& boundary = modified.cells.boundary;
  if (!entities_)
    entities_ = std::make_unique<const EntityMap>(
        parent.cells.boundary, boundary, tolerance::kOnSurface * boundary.bounds.diagonal());
  return *entities_;
}

std::unique_ptr<const CopyPlan> plan_of_nothing(const Problem& problem) {
  return std::make_unique<const CopyPlan>(FeatureModel{}, problem.modified.model, CopyLengths{},
                                          problem.run);
}

std::vector<Vec3> Attempt::faulty_places() const {
  if (candidate() == nullptr) return {};
  return remeshd::faulty_places(candidate()->verification);
}

double Attempt::seconds_of_its_own() const {
  double own = seconds.total;
  for (const TriedStrategy& rejected : tries) own -= rejected.seconds;
  return own;
}

std::vector<Vec3> faulty_places(const Verification& verification) {
  std::vector<Vec3> places;
  for (const MeshDefect& defect : verification.failures)
    if (defect.entity >= 0) places.push_back(defect.place);
  return places;
}

Region region_of(std::span<const Vec3> faulty_places, const SizeField& sizes) {
  double longest = 0;
  for (const Vec3& p : faulty_places) longest = std::fmax(longest, sizes(p));
  return {faulty_places, kAnewLimits.margin * longest, kAnewLimits.steps};
}

double share_in(const Region& region, const Attempt& attempt) {
  const StitchedMesh& whole = attempt.candidate()->whole;
  const PagedMesh& mesh = whole.mesh;
  std::size_t in = 0;
  mesh.tets.for_each([&](std::size_t k, const Tet& t) {
    in += whole.map.original_tet[k] < 0 && region.holds(centroid(mesh.nodes, t)) ? 1 : 0;
  });
  return static_cast<double>(in) / static_cast<double>(mesh.tets.size());
}

std::vector<std::string> in_words(std::span<const TriedStrategy> tried) {
  std::vector<std::string> all;
  for (const TriedStrategy& t : tried) all.push_back(t.strategy + ": " + t.reason);
  return all;
}

void add(PhaseSeconds& sum, const PhaseSeconds& more) {
  sum.setup += more.setup;
  sum.optimise += more.optimise;
  sum.extract += more.extract;
  sum.difference += more.difference;
  sum.copy += more.copy;
  sum.verify += more.verify;
}

Warning describe_fault(const Candidate& failed, const Problem& problem) {
  Warning warning{.code = WarningCode::Fallback};
  if (failed.verification.failures.empty()) {
    warning.message = "the mesh did not pass verification";
    return warning;
  }
  const MeshDefect& defect = failed.verification.failures.front();
  FailurePlace place = find_failure(defect, problem.modified.model, problem.plan().modified(),
                                    problem.modified.cells.boundary, problem.density.sizes.base());
  warning.message = describe(defect, place);
  if (!place.faces.empty()) warning.point = defect.place;
  warning.features = std::move(place.features);
  return warning;
}

}  // namespace remeshd
