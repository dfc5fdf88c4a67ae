#include "engine/remesh/density.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/base/error.h"
#include "engine/model/selection/selection_error.h"
#include "engine/nodes/density.h"
#include "engine/nodes/fill/fill.h"
#include "engine/remesh/node_budget.h"
#include "engine/remesh/node_limit.h"
#include "engine/sizing/size_controls.h"
#include "engine/sizing/size_rules.h"

namespace remeshd {
namespace {

struct NewcellBalls {
  double apart = 1.5, radius = 0.5;  ///< x edge length
};
constexpr NewcellBalls kBalls;
/// Fields that are alike: shares by which they may differ.
struct Alike {
  std::size_t sampled = 2500;  ///< about so many nodes of a start are compared
  double lengths = 0.05;       ///< for the start to serve
  double nodes = 0.02;         ///< for the base size to hold
  /// For an edit that asks for a number of nodes to keep its base's size. A loop may ask for the
  /// same number again and again while its model shrinks.
  double bases = 0.05;
};
constexpr Alike kAlike;
constexpr double kInPlace = 0.25;  // x base size: what moves by less is copied where it is

/// The warning that rules were weakened: how many edges circles get now, and how many nodes would
/// satisfy the rules.
Warning weakened(const Budgeted& budgeted, const Sizing& sizing) {
  const auto edges = static_cast<int>(sizing.edges_per_circle / budgeted.weakening);
  return {.code = WarningCode::DetailNotResolved,
          .message = "the nodes asked for are too few for the rules of sizes, which give circles " +
                     std::to_string(edges) + " edges now; " +
                     std::to_string(std::lround(budgeted.satisfying)) + " nodes would do",
          .nodes_needed = static_cast<std::uint32_t>(std::lround(budgeted.satisfying))};
}

/// The warning that the rules of the base, which were weakened for its number of nodes, hold on.
Warning still_weakened(double weakening, const Sizing& sizing) {
  const auto edges = static_cast<int>(sizing.edges_per_circle / weakening);
  return {
      .code = WarningCode::DetailNotResolved,
      .message =
          "the nodes of the first mesh are too few for the rules of sizes, which give circles " +
          std::to_string(edges) +
          " edges: mesh the model anew with more (an edit with rules of its own gets them in "
          "full)"};
}

/// The warning that a mesh is finer than an edit asks for.
Warning not_coarsened(double asked, double base) {
  return {.code = WarningCode::NodesFarFromTarget,
          .message = "an edit makes no edges longer than its base's, which are " +
                     std::to_string(base) + ": " + std::to_string(asked) +
                     " does not hold, mesh the model anew for that"};
}

/// The warning that a ball or box of the model's sizes is beside the model.
Warning outside(const std::string& size) {
  return {.code = WarningCode::GroupEmptied,
          .message = "the size " + size + " lies outside of the model",
          .groups = {size}};
}

/// The warning that faces have details smaller than the least size. It names their features, that
/// of the smallest detail first, and is where that is.
Warning below_least(const std::vector<SizeRules::AskedOnFace>& asked, double least,
                    const FeatureModel& model, const BoundaryModel& boundary) {
  Warning warning{.code = WarningCode::DetailNotResolved};
  for (const auto& detail : asked)
    for (const FaceName& name : boundary.faces[detail.face].names) {
      const std::string& id = model.features[name.feature].id;
      if (std::ranges::find(warning.features, id) == warning.features.end())
        warning.features.push_back(id);
    }
  warning.point = asked.front().at;
  warning.message = "details of " + first_and_more(warning.features) +
                    " are smaller than the least edge length, which is " + std::to_string(least);
  return warning;
}

/// What asks for edge lengths beside the rules: the model's size controls, and the dense places
/// that edits with a smaller edge length have left.
std::vector<SizeSource> asked_sizes(const FeatureModel& model, const BoundaryModel& boundary,
                                    const std::vector<SizedBall>& dense_places, const Run& run) {
  std::vector<SizeSource> sources = size_sources(model, boundary, run);
  for (const SizedBall& place : dense_places) sources.push_back(size_source(place));
  return sources;
}

/// The newcells of an edit, as balls that ask for an edge length.
std::vector<SizedBall> newcells(const Revision& parent, const FeatureModel& model,
                                double edge_length, const Run& run) {
  const CopyPlan plan(parent.copied_model(), model, copy_lengths(parent.edge_length, false), run);
  // With this lattice constant no point of space is further than half an edge length from a ball.
  const double constant = kBalls.apart * edge_length;
  std::vector<SizedBall> balls;
  for (const Vec3& p : fill_lattice(
           plan.changed(), [&](const Vec3& at) { return plan(at) == CopyPlan::kNew; },
           {.edge_length = edge_length, .density = 2 / (constant * constant * constant)}, run))
    balls.push_back({p, kBalls.radius * edge_length, edge_length});
  return balls;
}

/// How a field differs from the one that a start was made for, at the start's nodes, which are
/// dense where edges are short.
struct Difference {
  double most = 0;   ///< of edge lengths, as a share
  double nodes = 0;  ///< of the number of nodes, as a share
};
Difference difference(const SizeField& field, const Budgeted& made) {
  if (!made.start) return field.even() ? Difference{} : Difference{HUGE_VAL, HUGE_VAL};
  const std::vector<Vec3>& nodes = *made.start;
  double most = 0, sum = 0, count = 0;
  for (std::size_t n = 0; n < nodes.size(); n += 1 + nodes.size() / kAlike.sampled, ++count) {
    const double finer = made.sizes(nodes[n]) / field(nodes[n]);
    most = std::fmax(most, std::fabs(finer - 1));
    sum += finer * finer * finer;
  }
  return {.most = most, .nodes = count > 0 ? std::fabs(sum / count - 1) : 0};
}

/// Makes size fields of one model.
class FieldMaker {
 public:
  FieldMaker(const MeshOptions& options, const FeatureModel& model, const CellularModel& cells,
             const Run& run)
      : options_(options), model_(model), cells_(cells), run_(run) {}

  void ask_for(const std::vector<SizedBall>& dense_places) {
    asked_ = asked_sizes(model_, cells_.boundary, dense_places, run_);
  }
  [[nodiscard]] SizeRules rules(const BaseSizes& bases) const {
    return {cells_.boundary, options_.sizing, bases, run_, asked_};
  }
  /// `expected`: a guess at the base size.
  [[nodiscard]] Budgeted solved(std::uint32_t nodes, double expected) const {
    return sizes_for_budget(nodes, rules({coarsest_base(cells_, nodes), expected}), options_,
                            model_, cells_, run_);
  }

 private:
  const MeshOptions& options_;
  const FeatureModel& model_;
  const CellularModel& cells_;
  const Run& run_;
  std::vector<SizeSource> asked_;
};

/// What an edit asks for beside its base's density: smaller edge lengths in its newcells, which
/// hold there for later edits too. `edge_length`: asked for, or a guess at it where a number of
/// nodes is.
void densify_newcells(Density& density, double edge_length, const Revision& parent,
                      const MeshOptions& options, const FeatureModel& model, FieldMaker& fields,
                      const Run& run) {
  const double base = parent.edge_length;
  if (options.nodes) edge_length = fields.solved(*options.nodes, edge_length).sizes.base();
  density.inherited = edge_length >= (options.nodes ? 1 - kAlike.bases : 1) * base;
  if (density.inherited) return;
  const std::vector<SizedBall> more = newcells(parent, model, edge_length, run);
  density.dense_places.insert(density.dense_places.end(), more.begin(), more.end());
  fields.ask_for(density.dense_places);
}

/// Sets the size field and what follows from it. `edge_length`: the base size, or a guess at it
/// where a number of nodes is asked for.
void set_sizes(Density& density, double edge_length, const Revision& parent,
               const MeshOptions& options, const FeatureModel& model, const CellularModel& cells,
               const Run& run) {
  if (options.size.value_or(0) > parent.edge_length)
    density.warnings.push_back(not_coarsened(*options.size, parent.edge_length));
  if (options.sizing.even) {
    density.sizes = edge_length;
    return;
  }
  FieldMaker fields(options, model, cells, run);
  if (!density.count) density.dense_places = parent.dense_places;
  fields.ask_for(density.dense_places);
  if (!parent.output.mesh.tets.empty()) {
    densify_newcells(density, edge_length, parent, options, model, fields, run);
    edge_length = parent.edge_length;
  }
  // Rules that an edit has of its own hold in full.
  const bool same_rules = options.sizing == parent.options.sizing;
  Budgeted budgeted{.sizes = edge_length, .weakening = same_rules ? parent.rules_weakening : 1};
  const auto field_of = [&](const SizeRules& rules) {
    return rules.field(budgeted.sizes.base(), budgeted.weakening);
  };
  if (density.count) budgeted = fields.solved(*density.count, edge_length);
  // Later edits have rules for the base size alone, which may resolve other details than rules for
  // a guess at it: so has this mesh.
  SizeRules rules = fields.rules(budgeted.sizes.base());
  density.sizes = field_of(rules);
  if (density.count && difference(density.sizes, budgeted).nodes > kAlike.nodes) {
    budgeted = fields.solved(*density.count, budgeted.sizes.base());
    rules = fields.rules(budgeted.sizes.base());
    density.sizes = field_of(rules);
  }
  if (density.count) {
    if (budgeted.weakening > 1) density.warnings.push_back(weakened(budgeted, options.sizing));
    if (difference(density.sizes, budgeted).most <= kAlike.lengths)
      density.start = std::move(budgeted.start);
  } else if (budgeted.weakening > 1) {
    density.warnings.push_back(still_weakened(budgeted.weakening, options.sizing));
  }
  density.weakening = budgeted.weakening;
  density.fewest_links =
      rules.fewest_links(cells.boundary, density.sizes.base(), density.weakening);
  const auto too_small = rules.unresolved(density.sizes.base(), density.weakening);
  for (const std::string& size : sizes_outside(model, cells.boundary.bounds))
    density.warnings.push_back(outside(size));
  if (!too_small.empty())
    density.warnings.push_back(below_least(
        too_small, least_size(options.sizing, density.sizes.base()), model, cells.boundary));
}

}  // namespace

Density resolve_density(const Revision& parent, const MeshOptions& options,
                        const FeatureModel& model, const CellularModel& cells, const Run& run) {
  if (options.nodes && options.size)
    throw error::options_invalid("nodes", "give a number of nodes or an edge length, not both");
  if (options.nodes && *options.nodes < kMinNodes)
    throw error::options_invalid(
        "nodes", "at least " + std::to_string(kMinNodes) + " nodes have to be asked for");
  if (options.size && !(std::isfinite(*options.size) && *options.size > 0))
    throw error::options_invalid("size", "the edge length has to be a positive number");
  const double volume = cells.volume, area = cells.area;
  const bool first = parent.output.mesh.tets.empty();
  if (parent.model.features.empty())
    for (const std::string& size : sizes_of_nothing(model, cells.boundary, run))
      throw error::selector_empty(size);
  Density density;
  double edge_length = 0;
  if (options.size) {
    edge_length = *options.size;
    density.nodes_per_volume = expected_nodes(volume, area, edge_length) / volume;
  } else if (first || options.nodes) {
    const std::uint32_t nodes = options.nodes.value_or(kDefaultNodes);
    edge_length = edge_length_for(volume, area, nodes);
    density.nodes_per_volume = nodes / volume;
    if (first) density.count = nodes;
  } else {
    edge_length = parent.edge_length;
    // By the edge length, not by counting the parent's nodes: small errors of many edits would add
    // up.
    density.nodes_per_volume = expected_nodes(volume, area, edge_length) / volume;
    density.inherited = true;
  }
  edge_length = std::fmin(edge_length, parent.edge_length);
  check_node_limit(parent, extent_of(cells), edge_length, options, run);
  set_sizes(density, edge_length, parent, options, model, cells, run);
  return density;
}

CopyLengths copy_lengths(double base, bool even) {
  return {.edge_length = base, .in_place = even ? 0 : kInPlace * base};
}

SizeField sizes_of(const Revision& revision, const Run& run) {
  if (revision.sizes) return *revision.sizes;
  const BoundaryModel& boundary = revision.cells.boundary;
  return SizeRules(boundary, revision.options.sizing, revision.edge_length, run,
                   asked_sizes(revision.model, boundary, revision.dense_places, run))
      .field(revision.edge_length, revision.rules_weakening);
}

}  // namespace remeshd
