#include "engine/remesh/node_budget.h"

#include <algorithm>
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
  double close = 0.005;       ///< of the nodes asked for: a count off by less is good enough
  double still = 1e-3;        ///< of the base size: a smaller change ends the search
  int tries = 6;              ///< starts that are made and counted
  double coarsest = 2;        ///< x base size of an even mesh: no coarser one is looked for
  double fewest_edges = 7.2;  ///< rules ask for no fewer on a circle, which certainly gets 6 then
  double beside = 0.1;        ///< of a bracket: no try is nearer to its ends
  double worth = 0.03;        ///< share of the nodes that weaker rules have to save
  int bisections = 50;
  std::size_t sampled = 2500;  ///< samples of a start's nodes, and of the area of thin sides
};
constexpr BudgetLimits kBudgetLimits;

/// A start, the nodes that a mesh with some size field begins with, and what is asked for at a
/// sample of these nodes and at the sides of walls and gaps. From that it predicts the number of
/// nodes for other fields: a node stands for a volume that holds more or fewer as its edge length
/// changes.
class Start {
 public:
  /// `longest`: where longer edges than this are asked for, it counts as this.
  Start(SizeField field, std::vector<Vec3> nodes, const std::vector<ThinSide>& sides,
        double longest)
      : field_(std::move(field)), nodes_(std::move(nodes)) {
    const std::size_t step = 1 + nodes_.size() / kBudgetLimits.sampled;
    for (std::size_t n = 0; n < nodes_.size(); n += step)
      asked_.push_back(field_.asked_for(nodes_[n], longest));
    sample(sides, longest);
  }
  [[nodiscard]] const SizeField& field() const { return field_; }
  [[nodiscard]] const std::vector<Vec3>& places() const { return nodes_; }
  /// Nodes that a mesh with the field has.
  [[nodiscard]] double nodes() const { return expected(field_.base(), 1); }
  /// Nodes with another base size, and rules that ask for edges `longer` times as long as here.
  [[nodiscard]] double expected(double base, double longer) const {
    double sum = 0;
    for (const double asked : asked_) {
      const double finer = std::fmin(field_.base(), asked) / std::fmin(base, longer * asked);
      sum += finer * finer * finer;
    }
    if (!asked_.empty())
      sum *= static_cast<double>(nodes_.size()) / static_cast<double>(asked_.size());
    for (const auto& [side, weight, asked] : sides_)
      sum += weight * side.nodes(std::fmin(base, longer * asked));
    return sum;
  }

 private:
  struct AskedSide {
    ThinSide side;
    double weight, asked;
  };

  /// Samples the sides: divides their area into many equal parts and takes the side at the end of
  /// each, which stands for that part.
  void sample(const std::vector<ThinSide>& sides, double longest) {
    double area = 0, passed = 0;
    for (const ThinSide& side : sides) area += side.area;
    const double part = area / static_cast<double>(kBudgetLimits.sampled);
    for (const ThinSide& side : sides) {
      const double parts = std::floor((passed + side.area) / part) - std::floor(passed / part);
      passed += side.area;
      if (parts > 0)
        sides_.push_back({side, parts * part / side.area, field_.asked_for(side.middle, longest)});
    }
  }
  SizeField field_;
  std::vector<Vec3> nodes_;
  std::vector<double> asked_;  ///< by node of the sample
  std::vector<AskedSide> sides_;
};

/// How coarse a mesh is made: a base size, and once that is the coarsest, weaker and weaker rules.
struct Coarseness {
  double base, weakening;
};

/// The search for the coarseness with which a start has the nodes asked for. Its variable goes from
/// 0, finest, to 2: up to 1 the base size grows, then the rules are weakened. Starts that were made
/// bracket it; while they are all on one side, the last one predicts where it is.
class CoarsenessSearch {
 public:
  /// `guess`: the base size to begin with, half the coarsest; `weakest`: the largest weakening.
  CoarsenessSearch(double nodes, double guess, double weakest)
      : nodes_(nodes), guess_(guess), weakest_(weakest), now_(0.5) {}

  [[nodiscard]] Coarseness now() const { return at(now_); }

  /// Takes the start that was made with `now()`. Returns whether another is to be made, with what
  /// `now()` is after that.
  bool goes_on(const Start& start) {
    const double count = start.nodes();
    const double off = std::fabs(count / nodes_ - 1);
    if (off < least_off_) {
      least_off_ = off;
      best_ = {.sizes = start.field(),
               .weakening = now().weakening,
               .start = std::make_shared<const std::vector<Vec3>>(start.places())};
    }
    if (off < kBudgetLimits.close || ++tries_ == kBudgetLimits.tries) return false;
    (count > nodes_ ? fine_ : coarse_) = {now_, std::log(count / nodes_)};
    const Coarseness was = now();
    now_ = is_bracketed() ? between() : expected(start);
    return now().weakening != was.weakening ||
           std::fabs(now().base / was.base - 1) >= kBudgetLimits.still;
  }

  /// The start whose count is nearest to the nodes asked for, of all that were made.
  [[nodiscard]] Budgeted best() && { return std::move(best_); }

 private:
  [[nodiscard]] Coarseness at(double t) const {
    return {guess_ * std::pow(kBudgetLimits.coarsest, 2 * std::fmin(t, 1) - 1),
            std::pow(weakest_, std::fmax(t, 1) - 1)};
  }
  [[nodiscard]] bool is_bracketed() const {
    return std::isfinite(fine_.log_count) && std::isfinite(coarse_.log_count);
  }
  /// Interpolated from the counts at the ends of the bracket, but not next to an end: counts jump
  /// where films get edges.
  [[nodiscard]] double between() const {
    const double share = fine_.log_count / (fine_.log_count - coarse_.log_count);
    const double beside = kBudgetLimits.beside;
    return std::lerp(fine_.at, coarse_.at, std::clamp(share, beside, 1 - beside));
  }
  /// Where a start predicts the nodes asked for.
  [[nodiscard]] double expected(const Start& start) const {
    double fine = fine_.at, coarse = coarse_.at;
    for (int k = 0; k < kBudgetLimits.bisections; ++k) {
      const double middle = 0.5 * (fine + coarse);
      const Coarseness tried = at(middle);
      const double longer = tried.weakening / now().weakening;
      (start.expected(tried.base, longer) > nodes_ ? fine : coarse) = middle;
    }
    return 0.5 * (fine + coarse);
  }

  struct End {
    double at;
    double log_count = HUGE_VAL;  ///< log(its nodes / those asked for); infinite: not tried yet
  };

  double nodes_, guess_, weakest_;
  double now_;
  End fine_{0}, coarse_{2};  ///< the bracket: too many nodes, too few
  int tries_ = 0;
  double least_off_ = HUGE_VAL;
  Budgeted best_;
};

/// Makes starts of a model.
class Starts {
 public:
  /// `longest`: what is asked for beyond this limits no edge, whatever coarseness is tried.
  Starts(const SizeRules& rules, const MeshOptions& options, const FeatureModel& model,
         const Box& bounds, double longest, const Run& run)
      : rules_(rules),
        sides_(rules.sides()),
        options_(options),
        membership_(model),
        bounds_(bounds),
        longest_(longest),
        run_(run) {}

  [[nodiscard]] Start of(const Coarseness& c) const {
    SizeField field = rules_.field(c.base, c.weakening);
    const auto inside = [&](const Vec3& p) { return membership_.inside(p); };
    std::vector<Vec3> nodes = fill_graded({bounds_}, inside, field, options_.seed, run_);
    return Start(std::move(field), std::move(nodes), sides_, longest_);
  }

 private:
  const SizeRules& rules_;
  std::vector<ThinSide> sides_;
  const MeshOptions& options_;
  Membership membership_;
  const Box& bounds_;
  double longest_;
  const Run& run_;
};

/// The share of the nodes of a mesh with one field that one with another, coarser, does without;
/// about, from what both ask for at the nodes of a start.
double saved_share(const Start& start, const SizeField& fine, const SizeField& coarse) {
  const std::vector<Vec3>& places = start.places();
  double of_fine = 0, of_coarse = 0;
  for (std::size_t n = 0; n < places.size(); n += 1 + places.size() / kBudgetLimits.sampled) {
    const double finer = start.field()(places[n]) / fine(places[n]);
    const double longer = coarse(places[n]) / fine(places[n]);
    of_fine += finer * finer * finer;
    of_coarse += finer * finer * finer / (longer * longer * longer);
  }
  return of_fine > 0 ? 1 - of_coarse / of_fine : 0;
}

/// The number of nodes with which the rules hold without weakening: that for which a start with its
/// coarsest base size has as many. Counts jump where films get edges, so that two starts predict
/// it, and the larger number is taken.
/// @param start  made by unweakened rules, with any base size
double satisfying(const Start& start, const CellularModel& cells, const Starts& starts) {
  const auto told_by = [&](const Start& s, double nodes) {
    for (int i = 0; i < kBudgetLimits.bisections; ++i)
      nodes = s.expected(coarsest_base(cells, nodes), 1);
    return nodes;
  };
  const double guess = told_by(start, start.nodes());
  return std::fmax(guess, told_by(starts.of({coarsest_base(cells, guess), 1}), guess));
}

}  // namespace

double coarsest_base(const CellularModel& cells, double nodes) {
  return kBudgetLimits.coarsest * edge_length_for(cells.volume, cells.area, nodes);
}

Budgeted sizes_for_budget(std::uint32_t nodes, const SizeRules& rules, const MeshOptions& options,
                          const FeatureModel& model, const CellularModel& cells, const Run& run) {
  const double coarsest = coarsest_base(cells, nodes);
  const double weakest = std::fmax(1, options.sizing.edges_per_circle / kBudgetLimits.fewest_edges);
  const Starts starts(rules, options, model, cells.boundary.bounds, weakest * coarsest, run);
  const double guess = edge_length_for(cells.volume, cells.area, nodes);
  if (SizeField sizes = rules.field(guess, 1); sizes.even()) return {.sizes = std::move(sizes)};
  const Start first = starts.of({guess, 1});
  // Where sizes of the model ask for as short edges as the rules do, weaker rules save no node.
  const bool saves_nodes = saved_share(first, rules.field(coarsest, 1),
                                       rules.field(coarsest, weakest)) >= kBudgetLimits.worth;
  CoarsenessSearch search(nodes, guess, saves_nodes ? weakest : 1);
  if (search.goes_on(first))
    while (search.goes_on(starts.of(search.now()))) {
    }
  Budgeted made = std::move(search).best();
  if (made.weakening > 1) made.satisfying = satisfying(first, cells, starts);
  return made;
}

}  // namespace remeshd
