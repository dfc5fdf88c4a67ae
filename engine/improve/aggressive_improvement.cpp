#include "engine/improve/aggressive_improvement.h"

#include <algorithm>
#include <utility>

#include "engine/mesh/grouping.h"

namespace remeshd {
namespace {

struct AggressiveLimits {
  std::size_t crowd = 2000;    ///< most tets of a sound neighbourhood, which has about 500
  int descent_rounds = 12;     ///< over the nodes at a residual tet's neighbours
  int compass_rounds = 4;      ///< over the nodes of a tet
  double compass_gain = 1e-4;  ///< of the score, least for a step: bounds their number
  double compass_start = 0.1, compass_end = 0.004;  ///< steps, x local edge length
  double start_score = 0.2;  ///< least of perturbed tets; moves seldom mend worse ones
};
constexpr AggressiveLimits kAggressiveLimits;
/// Steepness k of `Score::energy`, round by round: low at first, so that deficits spread over all
/// tets, then higher, so that the worst tets count.
constexpr int kSteepness[] = {3, 3, 3, 3, 4, 4, 5, 5};
constexpr int kPerturbations = 10;  // edges and facets of a tet, each of which is taken out

}  // namespace

bool AggressiveImprovement::Rank::better_than(const Rank& other) const {
  if (worst > other.worst + kLeastGain) return true;
  const bool meets_goals = deficit == 0 && other.deficit > 0;
  return worst >= other.worst && (meets_goals || deficit < other.deficit - kLeastGain);
}

std::vector<std::int32_t> AggressiveImprovement::nodes_round(std::int32_t t) const {
  std::vector<std::int32_t> nodes;
  for (const std::int32_t node : mesh_.tet(t))
    for (const std::int32_t s : mesh_.tets_of(node))
      nodes.insert(nodes.end(), mesh_.tet(s).begin(), mesh_.tet(s).end());
  sort_unique(nodes);
  return nodes;
}

std::vector<std::int32_t> AggressiveImprovement::tets_at(
    const std::vector<std::int32_t>& nodes) const {
  std::vector<std::int32_t> tets;
  for (const std::int32_t node : nodes)
    tets.insert(tets.end(), mesh_.tets_of(node).begin(), mesh_.tets_of(node).end());
  sort_unique(tets);
  return tets;
}

AggressiveImprovement::Rank AggressiveImprovement::rank(
    const std::vector<std::int32_t>& tets) const {
  Rank now;
  for (const std::int32_t t : tets) {
    const double score = std::min(1.0, score_(mesh_, t));
    now.worst = std::min(now.worst, score);
    now.deficit += 1 - score;
  }
  return now;
}

AggressiveImprovement::Neighbourhood AggressiveImprovement::neighbourhood(std::int32_t t) const {
  Neighbourhood tets;
  for (const std::int32_t s : tets_at(nodes_round(t))) tets.emplace_back(s, mesh_.stamp(s));
  return tets;
}

bool AggressiveImprovement::is_crowded(const Neighbourhood& neighbourhood) {
  return neighbourhood.size() > kAggressiveLimits.crowd;
}

bool AggressiveImprovement::descend(std::int32_t t) {
  const std::vector<std::int32_t> nodes = nodes_round(t);
  std::vector<std::int32_t> tets = tets_at(nodes);
  const Rank before = rank(tets);
  Rank after = before;
  // Which nodes may move, and their facets, is the same in every round.
  struct Movable {
    std::int32_t node;
    std::vector<Triangle> facets;
    std::uint32_t vain_star;  ///< LocalMesh::star_stamp when a step last failed
  };
  std::vector<Movable> movable;
  for (const std::int32_t node : nodes)
    if (rules_.facets_at(node, facets_))
      movable.push_back({node, facets_, mesh_.star_stamp(node) - 1});
  mesh_.begin_trial();
  for (int round = 0; round < kAggressiveLimits.descent_rounds && after.deficit > 0; ++round) {
    for (auto& [node, facets, vain_star] : movable) {
      if (mesh_.star_stamp(node) == vain_star) continue;
      Vec3 position;
      if (smoother_.energy_descent_step(node, facets, position))
        mesh_.move(node, position);
      else
        vain_star = mesh_.star_stamp(node);
    }
    after = rank(tets);
  }
  return end_trial(!(after.worst < before.worst) && after.better_than(before), std::move(tets));
}

bool AggressiveImprovement::end_trial(bool helped, std::vector<std::int32_t> tets) {
  if (!helped) {
    mesh_.undo_trial();
    return false;
  }
  mesh_.keep_trial();
  touched_ = std::move(tets);
  return true;
}

bool AggressiveImprovement::reconnect(std::int32_t t, const TetQuality& quality) {
  const Tet tet = mesh_.tet(t);
  double floor = quality(mesh_, t) + kLeastGain;
  bool found = false;
  const auto take = [&] {
    std::swap(trial_, best_);
    floor = best_.quality;
    found = true;
  };
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      if (remove_edge(mesh_, rules_, tet[i], tet[j], max_ring_, floor, trial_, quality)) take();
  for (int i = 0; i < 4; ++i)
    if (remove_faces(mesh_, t, i, floor, trial_, quality)) take();
  if (!found) return false;
  touched_.clear();
  mesh_.replace(best_.old_tets, best_.fresh, touched_);
  return true;
}

bool AggressiveImprovement::compass_search(std::int32_t t) {
  const Tet tet = mesh_.tet(t);
  bool changed = false;
  for (int round = 0; round < kAggressiveLimits.compass_rounds && !good(t); ++round) {
    bool moved = false;
    for (const std::int32_t node : tet) moved |= compass_search_node(node);
    if (!moved) break;
    changed = true;
  }
  if (changed) touched_ = tets_at({tet.begin(), tet.end()});
  return changed;
}

double AggressiveImprovement::worst_at(std::int32_t node, const Vec3& p, double floor) const {
  double worst = 1;
  for (const std::int32_t t : mesh_.tets_of(node)) {
    const Tet& tet = mesh_.tet(t);
    const auto corner = [&](int i) { return tet[i] == node ? p : mesh_.node(tet[i]); };
    worst = std::min(worst, score_(corner(0), corner(1), corner(2), corner(3)));
    if (worst <= floor) break;
  }
  return worst;
}

bool AggressiveImprovement::compass_search_node(std::int32_t node) {
  if (!rules_.facets_at(node, facets_)) return false;
  double length = 0;
  for (const std::int32_t n : mesh_.tet(mesh_.tets_of(node)[0]))
    length = std::max(length, distance(mesh_.node(n), mesh_.node(node)));
  Vec3 place = mesh_.node(node);
  double reached = worst_at(node, place, -1);
  const double before = reached;
  for (double step = kAggressiveLimits.compass_start * length;
       step > kAggressiveLimits.compass_end * length && reached < 1;) {
    Vec3 best = place;
    for (int k = 0; k < 6; ++k) {
      Vec3 towards{};
      (k / 2 == 0 ? towards.x : k / 2 == 1 ? towards.y : towards.z) = k % 2 ? -step : step;
      const Vec3 p = rules_.settle(node, place + towards);
      const double s = worst_at(node, p, reached + kAggressiveLimits.compass_gain);
      if (s <= reached + kAggressiveLimits.compass_gain ||
          (!facets_.empty() && !rules_.may_move(node, p, facets_)))
        continue;
      reached = s;
      best = p;
    }
    if (best == place)
      step *= 0.5;
    else
      place = best;
  }
  if (reached < before + kLeastGain) return false;
  mesh_.move(node, place);
  return true;
}

bool AggressiveImprovement::optimise_neighbourhood(std::int32_t t) {
  return optimise_from({}, nodes_round(t));
}

bool AggressiveImprovement::perturb_and_optimise(std::int32_t t) {
  const std::vector<std::int32_t> nodes = nodes_round(t);
  Reconnection start;
  for (int way = 0; way < kPerturbations; ++way)
    if (take_out(t, way, start) && optimise_from(start, nodes)) return true;
  return false;
}

bool AggressiveImprovement::take_out(std::int32_t t, int way, Reconnection& out) const {
  constexpr int kEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  const TetQuality quality(score_, 0);
  if (way >= 6) return remove_faces(mesh_, t, way - 6, kAggressiveLimits.start_score, out, quality);
  const Tet& tet = mesh_.tet(t);
  return remove_edge(mesh_, rules_, tet[kEdges[way][0]], tet[kEdges[way][1]], max_ring_,
                     kAggressiveLimits.start_score, out, quality);
}

bool AggressiveImprovement::optimise_from(const Reconnection& start,
                                          const std::vector<std::int32_t>& nodes) {
  const Rank before = rank(tets_at(nodes));
  Rank after = before;
  mesh_.begin_trial();
  if (!start.old_tets.empty()) {
    touched_.clear();
    mesh_.replace(start.old_tets, start.fresh, touched_);
  }
  for (const int steepness : kSteepness) {
    optimise_round(nodes, steepness);
    after = rank(tets_at(nodes));
    if (after.deficit <= 0) break;
  }
  std::vector<std::int32_t> tets = tets_at(nodes);
  if (after.deficit > 0) {
    compass_search_all(tets);
    after = rank(tets);
  }
  return end_trial(after.better_than(before), std::move(tets));
}

void AggressiveImprovement::optimise_round(const std::vector<std::int32_t>& nodes, int steepness) {
  for (const std::int32_t node : nodes) {
    Vec3 position;
    if (smoother_.energy_descent_step(node, score_, steepness, position))
      mesh_.move(node, position);
  }
  // Only tets with all four corners among these nodes are reconnected, so that what changes stays
  // among the tets at these nodes.
  const auto within = [&](std::int32_t t) {
    return std::ranges::all_of(mesh_.tet(t), [&](std::int32_t n) {
      return std::binary_search(nodes.begin(), nodes.end(), n);
    });
  };
  for (const std::int32_t t : tets_at(nodes))
    if (mesh_.used(t) && within(t) && !good(t)) reconnect(t);
}

void AggressiveImprovement::compass_search_all(const std::vector<std::int32_t>& tets) {
  for (const std::int32_t t : tets)
    if (!good(t)) compass_search(t);
}

}  // namespace remeshd
