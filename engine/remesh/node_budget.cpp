#include "engine/remesh/node_budget.h"

#include <cmath>
#include <vector>

#include "engine/model/solid.h"
#include "engine/nodes/fill/fill.h"
#include "engine/sizing/size_rules.h"

namespace remeshd {

namespace {

struct BudgetLimits {
  double close = 0.01;  ///< of the nodes asked for
  int tries = 5;        ///< starts that are made and counted
  double widest = 4;    ///< x base size: no other one is looked for
  int bisections = 50;
};
constexpr BudgetLimits kLimits;

/// The base size with which a start of so many nodes is to be expected, by one with another: each
/// of its nodes stands for a volume that holds more or fewer as its edge length changes.
double better_base(double nodes, const std::vector<Vec3>& start, const SizeField& sizes) {
  std::vector<double> asked;
  for (const Vec3& p : start) asked.push_back(sizes.asked_for(p));
  const auto expected = [&](double base) {
    double sum = 0;
    for (const double a : asked) {
      const double finer = std::fmin(sizes.base(), a) / std::fmin(base, a);
      sum += finer * finer * finer;
    }
    return sum;
  };
  double low = sizes.base() / kLimits.widest, high = sizes.base() * kLimits.widest;
  for (int k = 0; k < kLimits.bisections; ++k) {
    const double middle = std::sqrt(low * high);
    (expected(middle) > nodes ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace

SizeField sizes_for_budget(std::uint32_t nodes, const SizeField& first, const MeshOptions& options,
                           const FeatureModel& model, const CellularModel& cells, const Run& run) {
  const Membership membership(model);
  const auto inside = [&](const Vec3& p) { return membership.inside(p); };
  SizeField sizes = first;
  for (int k = 0; k < kLimits.tries; ++k) {
    const std::vector<Vec3> start =
        fill_graded({cells.boundary.bounds}, inside, sizes, options.seed, run);
    const auto found = static_cast<double>(start.size());
    if (std::fabs(found / nodes - 1) < kLimits.close) break;
    sizes = size_field(cells.boundary, options.sizing, better_base(nodes, start, sizes));
  }
  return sizes;
}

}  // namespace remeshd
