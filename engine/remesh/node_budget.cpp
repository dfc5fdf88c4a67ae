#include "engine/remesh/node_budget.h"

#include <cmath>
#include <utility>
#include <vector>

#include "engine/model/solid.h"
#include "engine/nodes/density.h"
#include "engine/nodes/fill/fill.h"
#include "engine/sizing/size_rules.h"

namespace remeshd {

namespace {

struct BudgetLimits {
  double close = 0.005;       ///< of the nodes asked for
  double still = 1e-3;        ///< of the base size: less of a change is none
  int tries = 5;              ///< starts that are made and counted
  double coarsest = 2;        ///< x base size of an even mesh: no coarser one is looked for
  double fewest_edges = 7.2;  ///< asked for on a circle, of which 6 are certain: no fewer
  int bisections = 50;
  int recounts = 3;         ///< of the nodes that would do
  double recounted = 0.05;  ///< of them: as near to the last count they are not counted again
};
constexpr BudgetLimits kBudgetLimits;

/// A start with some field, and what the field asks for at its nodes and at the sides of walls and
/// gaps. Each node stands for a volume that holds more or fewer nodes as its edge length changes.
class Start {
 public:
  Start(SizeField field, const std::vector<Vec3>& nodes, const std::vector<ThinSide>& sides)
      : field_(std::move(field)) {
    asked_.reserve(nodes.size());
    for (const Vec3& p : nodes) asked_.push_back(field_.asked_for(p));
    sides_.reserve(sides.size());
    for (const ThinSide& side : sides) sides_.push_back({side, field_.asked_for(side.middle)});
  }
  [[nodiscard]] const SizeField& field() const { return field_; }
  /// Nodes that a mesh with the field has.
  [[nodiscard]] double nodes() const { return expected(field_.base(), 1); }
  /// Nodes with another base size and with rules that ask for `longer` times longer edges.
  [[nodiscard]] double expected(double base, double longer) const {
    double sum = 0;
    for (const double asked : asked_) {
      const double finer = std::fmin(field_.base(), asked) / std::fmin(base, longer * asked);
      sum += finer * finer * finer;
    }
    for (const auto& [side, asked] : sides_) sum += side.nodes(std::fmin(base, longer * asked));
    return sum;
  }

 private:
  struct AskedSide {
    ThinSide side;
    double asked;
  };
  SizeField field_;
  std::vector<double> asked_;  ///< by node
  std::vector<AskedSide> sides_;
};

/// How coarse a mesh is made: a base size, and once that is the coarsest, weaker and weaker rules.
struct Coarseness {
  double base, weakening;
};

/// Step `t` of a way from 0, finest, to 2.
Coarseness coarseness(double t, double guess, double weakest) {
  const double r = kBudgetLimits.coarsest;
  return {guess * std::pow(r, 2 * std::fmin(t, 1) - 1), std::pow(weakest, std::fmax(t, 1) - 1)};
}

/// How coarse a mesh of so many nodes is to be expected to be, by the start of one that is `now`.
Coarseness better_coarseness(double nodes, const Start& start, const Coarseness& now, double guess,
                             double weakest) {
  double fine = 0, coarse = 2;
  for (int k = 0; k < kBudgetLimits.bisections; ++k) {
    const double middle = 0.5 * (fine + coarse);
    const Coarseness tried = coarseness(middle, guess, weakest);
    (start.expected(tried.base, tried.weakening / now.weakening) > nodes ? fine : coarse) = middle;
  }
  return coarseness(0.5 * (fine + coarse), guess, weakest);
}

/// Makes starts of a model.
class Starts {
 public:
  Starts(const SizeRules& rules, const MeshOptions& options, const FeatureModel& model,
         const Box& bounds, const Run& run)
      : rules_(rules),
        sides_(rules.sides()),
        options_(options),
        membership_(model),
        bounds_(bounds),
        run_(run) {}

  [[nodiscard]] Start of(const Coarseness& c) const {
    SizeField field = rules_.field(c.base, c.weakening);
    const auto inside = [&](const Vec3& p) { return membership_.inside(p); };
    const std::vector<Vec3> nodes = fill_graded({bounds_}, inside, field, options_.seed, run_);
    return Start(std::move(field), nodes, sides_);
  }

 private:
  const SizeRules& rules_;
  std::vector<ThinSide> sides_;
  const MeshOptions& options_;
  Membership membership_;
  const Box& bounds_;
  const Run& run_;
};

/// Nodes that make the rules hold without weakening: so many that a start with the coarsest base
/// size for them has as many.
double satisfying(double nodes, const CellularModel& cells, const Starts& starts) {
  for (int k = 0; k < kBudgetLimits.recounts; ++k) {
    const Start start = starts.of({coarsest_base(cells, nodes), 1});
    const double before = nodes;
    for (int i = 0; i < kBudgetLimits.bisections; ++i)
      nodes = start.expected(coarsest_base(cells, nodes), 1);
    if (std::fabs(nodes / before - 1) < kBudgetLimits.recounted) break;
  }
  return nodes;
}

}  // namespace

double coarsest_base(const CellularModel& cells, double nodes) {
  return kBudgetLimits.coarsest * edge_length_for(cells.volume, cells.area, nodes);
}

Budgeted sizes_for_budget(std::uint32_t nodes, const SizeRules& rules, const MeshOptions& options,
                          const FeatureModel& model, const CellularModel& cells, const Run& run) {
  const Starts starts(rules, options, model, cells.boundary.bounds, run);
  const double guess = edge_length_for(cells.volume, cells.area, nodes);
  const double weakest = std::fmax(1, options.sizing.edges_per_circle / kBudgetLimits.fewest_edges);
  Coarseness now{guess, 1};
  if (SizeField sizes = rules.field(guess, 1); sizes.even()) return {std::move(sizes)};
  for (int k = 1;; ++k) {
    const Start start = starts.of(now);
    const Coarseness better = better_coarseness(nodes, start, now, guess, weakest);
    const bool still = better.weakening == now.weakening &&
                       std::fabs(better.base / now.base - 1) < kBudgetLimits.still;
    if (k < kBudgetLimits.tries && !still &&
        std::fabs(start.nodes() / nodes - 1) >= kBudgetLimits.close) {
      now = better;
      continue;
    }
    Budgeted made{start.field(), now.weakening};
    if (now.weakening > 1) made.satisfying = satisfying(nodes, cells, starts);
    return made;
  }
}

}  // namespace remeshd
