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
  double close = 0.01;        ///< of the nodes asked for
  double still = 1e-3;        ///< of the base size: less of a change is none
  int tries = 5;              ///< starts that are made and counted
  double coarsest = 2;        ///< x base size of an even mesh: no coarser one is looked for
  double fewest_edges = 7.2;  ///< asked for on a circle, of which 6 are certain: no fewer
  int bisections = 50;
  int recounts = 3;         ///< of the nodes that would do
  double recounted = 0.05;  ///< of them: as near to the last count they are not counted again
};
constexpr BudgetLimits kLimits;

/// What the field asks for at the nodes of a start. Each of them stands for a volume that holds
/// more or fewer nodes as its edge length changes.
class Expectation {
 public:
  Expectation(const std::vector<Vec3>& start, const SizeField& sizes) : base_(sizes.base()) {
    asked_.reserve(start.size());
    for (const Vec3& p : start) asked_.push_back(sizes.asked_for(p));
  }
  /// Nodes with another base size and with rules that ask for `longer` times longer edges.
  [[nodiscard]] double nodes(double base, double longer) const {
    double sum = 0;
    for (const double a : asked_) {
      const double finer = std::fmin(base_, a) / std::fmin(base, longer * a);
      sum += finer * finer * finer;
    }
    return sum;
  }

 private:
  double base_;
  std::vector<double> asked_;
};

/// How coarse a mesh is made: a base size, and once that is the coarsest, weaker and weaker rules.
struct Coarseness {
  double base, weakening;
};

/// Step `t` of a way from 0, finest, to 2.
Coarseness coarseness(double t, double guess, double weakest) {
  const double r = kLimits.coarsest;
  return {guess * std::pow(r, 2 * std::fmin(t, 1) - 1), std::pow(weakest, std::fmax(t, 1) - 1)};
}

/// How coarse a mesh of so many nodes is to be expected to be, by the start of one that is `now`.
Coarseness better_coarseness(double nodes, const Expectation& expected, const Coarseness& now,
                             double guess, double weakest) {
  double fine = 0, coarse = 2;
  for (int k = 0; k < kLimits.bisections; ++k) {
    const double middle = 0.5 * (fine + coarse);
    const Coarseness tried = coarseness(middle, guess, weakest);
    (expected.nodes(tried.base, tried.weakening / now.weakening) > nodes ? fine : coarse) = middle;
  }
  return coarseness(0.5 * (fine + coarse), guess, weakest);
}

/// Starts of a model, counted.
class Starts {
 public:
  Starts(const SizeRules& rules, const MeshOptions& options, const FeatureModel& model,
         const Box& bounds, const Run& run)
      : rules_(rules), options_(options), membership_(model), bounds_(bounds), run_(run) {}

  struct Start {
    SizeField sizes;
    std::vector<Vec3> nodes;
    double sides;  ///< nodes that walls and gaps will get beside
    [[nodiscard]] double count() const { return static_cast<double>(nodes.size()) + sides; }
  };
  [[nodiscard]] Start of(const Coarseness& c) const {
    SizeField sizes = rules_.field(c.base, c.weakening);
    const auto inside = [&](const Vec3& p) { return membership_.inside(p); };
    std::vector<Vec3> nodes = fill_graded({bounds_}, inside, sizes, options_.seed, run_);
    const double sides = rules_.nodes_of_sides(sizes);
    return {std::move(sizes), std::move(nodes), sides};
  }

 private:
  const SizeRules& rules_;
  const MeshOptions& options_;
  Membership membership_;
  const Box& bounds_;
  const Run& run_;
};

/// Nodes that make the rules hold without weakening: so many that a start with the coarsest base
/// size for them has as many.
double satisfying(double nodes, const CellularModel& cells, const Starts& starts) {
  for (int k = 0; k < kLimits.recounts; ++k) {
    const double base = coarsest_base(cells, nodes);
    const Starts::Start start = starts.of({base, 1});
    const Expectation expected(start.nodes, start.sizes);
    const double before = nodes;
    for (int i = 0; i < kLimits.bisections; ++i)
      nodes = start.sides + expected.nodes(coarsest_base(cells, nodes), 1);
    if (std::fabs(nodes / before - 1) < kLimits.recounted) break;
  }
  return nodes;
}

}  // namespace

double coarsest_base(const CellularModel& cells, double nodes) {
  return kLimits.coarsest * edge_length_for(cells.volume, cells.area, nodes);
}

Budgeted sizes_for_budget(std::uint32_t nodes, const SizeRules& rules, const MeshOptions& options,
                          const FeatureModel& model, const CellularModel& cells, const Run& run) {
  const Starts starts(rules, options, model, cells.boundary.bounds, run);
  const double guess = edge_length_for(cells.volume, cells.area, nodes);
  const double weakest = std::fmax(1, options.sizing.edges_per_circle / kLimits.fewest_edges);
  Coarseness now{guess, 1};
  if (SizeField sizes = rules.field(guess, 1); sizes.even()) return {std::move(sizes)};
  for (int k = 1;; ++k) {
    Starts::Start start = starts.of(now);
    const Coarseness better = better_coarseness(
        nodes - start.sides, Expectation(start.nodes, start.sizes), now, guess, weakest);
    const bool still =
        better.weakening == now.weakening && std::fabs(better.base / now.base - 1) < kLimits.still;
    if (k < kLimits.tries && !still && std::fabs(start.count() / nodes - 1) >= kLimits.close) {
      now = better;
      continue;
    }
    Budgeted made{std::move(start.sizes), now.weakening};
    if (now.weakening > 1) made.satisfying = satisfying(nodes, cells, starts);
    return made;
  }
}

}  // namespace remeshd
