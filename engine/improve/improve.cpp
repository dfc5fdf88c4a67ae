#include "engine/improve/improve.h"

#include <algorithm>
#include <map>
#include <queue>

#include "engine/improve/aggressive_improvement.h"
#include "engine/improve/boundary_rules.h"
#include "engine/improve/local_mesh.h"
#include "engine/improve/reconnect.h"
#include "engine/improve/score.h"
#include "engine/improve/smooth.h"

namespace remeshd {
namespace {

struct CleanUpLimits {
  /// Least gain of measure that smoothing aims at, since a tet with too small an angle may be above
  /// the threshold already.
  double sharp_gain = 0.02;
  int neighbourhood_passes = 2;
  /// A node in more tets is not smoothed: only broken meshes have such, and each tet would try it.
  std::size_t tets_at_node = 300;
  double bad_at_interface = 0.9;  ///< score below which a tet with a locked node is counted
  int jobs_per_poll = 64;
};
constexpr CleanUpLimits kCleanUpLimits;

/// How many residual tets one kind of operation is tried on in a pass: one for every
/// `dirty_for_one` dirty tets, but at least one and at most `most`. A usual mesh of 15,000 nodes
/// has fewer than ten residual tets; there are more only on parts so thin for their edge length
/// that the threshold is out of reach. On such parts, without this limit, an edit of a coarse mesh
/// would spend more time on tets that its parent has left than on its own.
struct Budget {
  std::size_t most;
  std::size_t dirty_for_one;
  [[nodiscard]] std::size_t of(std::size_t dirty) const {
    return std::clamp<std::size_t>(dirty / dirty_for_one, 1, most);
  }
};
struct CleanUpBudgets {
  Budget residual{40, 150};        ///< and one more per thousand tets
  Budget neighbourhoods{12, 500};  ///< of those that are optimised
  Budget perturbed{3, 2000};       ///< which costs ten times as much
};
constexpr CleanUpBudgets kBudgets;

/// A tet to be worked on; out of date once its slot's stamp has grown.
struct Job {
  double quality;
  std::int32_t tet;
  std::uint32_t stamp;
};
struct BetterFirst {
  bool operator()(const Job& a, const Job& b) const {
    return a.quality != b.quality ? a.quality > b.quality : a.tet > b.tet;
  }
};

class CleanUp {
 public:
  CleanUp(const TetMesh& mesh, std::span<const Support> supports, const BoundaryModel& boundary,
          std::span<const std::uint8_t> dirty, const ImproveOptions& options, const Run& run)
      : start_(mesh),
        mesh_(mesh, options.locked, run),
        rules_(boundary, supports, mesh_, options.chord_tolerance),
        smoother_(mesh_, rules_),
        options_(options),
        run_(run),
        max_ring_(std::clamp(options.max_ring, 3, EdgeRing::kMaxTets)),
        score_(options.threshold, options.min_dihedral),
        aggressive_(mesh_, rules_, smoother_, score_, max_ring_),
        work_(mesh.tets.size(), Work::Same),
        smoothed_in_vain_(mesh.nodes.size()) {
    for (std::size_t t = 0; t < dirty.size(); ++t) {
      if (dirty[t] == 0) continue;
      work_[t] = Work::Changed;
      ++dirty_;
    }
    if (options_.confined) mark_nodes_of_dirty();
  }

  ImproveResult work() {
    InVain in_vain;
    for (int pass = 0; pass < options_.passes; ++pass) {
      for (const std::int32_t t : bad_tets()) push(t);
      bool changed = drain();
      changed |= on_residual_tets(most_residual(), Spare::Neighbours, in_vain, [&](std::int32_t t) {
        return aggressive_.descend(t) || aggressive_.reconnect(t) || aggressive_.compass_search(t);
      });
      if (!changed) break;
    }
    if (bad_tets().size() <= options_.most_left * most_residual()) optimise_residual_tets();
    ImproveResult result;
    for (const std::int32_t t : bad_tets()) {
      ++result.below_threshold;
      if (std::ranges::min(mesh_.tet(t)) < options_.locked &&
          score_(mesh_, t) < kCleanUpLimits.bad_at_interface)
        ++result.bad_at_interface;
    }
    result.mesh = mesh_.result();
    result.was.reserve(result.mesh.tets.size());
    for (std::int32_t t = 0; t < mesh_.slots(); ++t) {
      if (!mesh_.used(t)) continue;
      result.was.push_back(is_of_input(t) ? t : -1);
    }
    result.node_moved.resize(start_.nodes.size());
    for (std::size_t n = 0; n < start_.nodes.size(); ++n)
      result.node_moved[n] = result.mesh.nodes[n] != start_.nodes[n] ? 1 : 0;
    return result;
  }

 private:
  /// Whether a tet may be worked on, and why. Changed: it was dirty in the input, or an operation
  /// made it. Moved: another tet of the input, one of whose nodes an operation may have moved.
  /// Same: any other, which is left alone.
  enum class Work : std::uint8_t { Same, Moved, Changed };

  [[nodiscard]] bool bad(std::int32_t t) const {
    return mesh_.used(t) && work_[t] != Work::Same && is_near(mesh_.tet(t)) &&
           score_(mesh_, t) < enough(t);
  }

  /// The score from which on a tet is left alone: 1; if confined, of a tet of the input that was
  /// not dirty, no more than it had there.
  [[nodiscard]] double enough(std::int32_t t) const {
    if (!options_.confined || work_[t] != Work::Moved || !is_of_input(t)) return 1;
    const auto& p = start_.nodes;
    const Tet& n = mesh_.tet(t);
    return std::min(1.0, score_(p[n[0]], p[n[1]], p[n[2]], p[n[3]]));
  }
  [[nodiscard]] bool is_of_input(std::int32_t t) const {
    const auto slot = static_cast<std::size_t>(t);
    return slot < start_.tets.size() && start_.tets[slot] == mesh_.tet(t);
  }

  [[nodiscard]] bool is_near(const Tet& t) const {
    return !options_.confined ||
           std::ranges::any_of(t, [&](std::int32_t n) { return at_dirty_[n] != 0; });
  }
  void mark_nodes_of_dirty() {
    at_dirty_.assign(start_.nodes.size(), 0);
    for (std::size_t t = 0; t < start_.tets.size(); ++t)
      if (work_[t] == Work::Changed)
        for (const std::int32_t n : start_.tets[t]) at_dirty_[n] = 1;
  }

  [[nodiscard]] std::vector<std::int32_t> bad_tets() const {
    std::vector<std::int32_t> tets;
    Polling poll(run_);
    for (std::int32_t t = 0; t < mesh_.slots(); ++t) {
      poll();
      if (bad(t)) tets.push_back(t);
    }
    return tets;
  }

  /// By tet, its neighbourhood when an operation failed there.
  using InVain = std::map<std::int32_t, AggressiveImprovement::Neighbourhood>;

  /// Which neighbours of a tet that an operation was tried on are spared in the pass: the operation
  /// has tried to move their nodes, too. Where a mesh is coarse for its model bad tets come in
  /// dozens side by side. Neighbours of a crowded tet are always spared.
  enum class Spare : std::uint8_t {
    Neighbours,        ///< all that have a node in common with it
    NeighboursInVain,  ///< the same, but only where it failed
  };

  /// Tries an operation on the worst of the bad tets, `most` of them; true if it improved one.
  template <class Operation>
  bool on_residual_tets(std::size_t most, Spare spare, InVain& in_vain,
                        const Operation& operation) {
    bool changed = false;
    std::vector<std::uint8_t> spared(mesh_.slots(), 0);
    const auto spare_neighbours = [&](std::int32_t t) {
      spared.resize(mesh_.slots(), 0);
      for (const std::int32_t n : mesh_.tet(t))
        for (const std::int32_t s : mesh_.tets_of(n)) spared[s] = 1;
    };
    for (const std::int32_t t : worst_first()) {
      run_.poll();
      if (!bad(t) || spared[t] != 0) continue;
      AggressiveImprovement::Neighbourhood round = aggressive_.neighbourhood(t);
      if (AggressiveImprovement::is_crowded(round)) {  // its neighbours are too, by thousands
        spare_neighbours(t);
        continue;
      }
      if (const auto tried = in_vain.find(t); tried != in_vain.end() && tried->second == round)
        continue;
      if (most-- == 0) break;
      if (spare == Spare::Neighbours) spare_neighbours(t);
      if (!operation(t)) {
        spare_neighbours(t);
        in_vain[t] = std::move(round);
        continue;
      }
      touch(aggressive_.touched());
      drain();
      changed = true;
    }
    return changed;
  }

  [[nodiscard]] std::size_t most_residual() const {
    return kBudgets.residual.of(dirty_) + static_cast<std::size_t>(mesh_.slots()) / 1000;
  }

  /// Works on the worst of the bad tets that are left. Pre: they are few; where many are left the
  /// goals are out of reach, and each neighbourhood is full of bad tets.
  void optimise_residual_tets() {
    InVain in_vain;
    const auto optimise = [&](std::int32_t t) { return aggressive_.optimise_neighbourhood(t); };
    for (int pass = 0; pass < kCleanUpLimits.neighbourhood_passes; ++pass)
      if (!on_residual_tets(kBudgets.neighbourhoods.of(dirty_), Spare::NeighboursInVain, in_vain,
                            optimise))
        break;
    in_vain.clear();
    on_residual_tets(kBudgets.perturbed.of(dirty_), Spare::NeighboursInVain, in_vain,
                     [&](std::int32_t t) { return aggressive_.perturb_and_optimise(t); });
  }

  [[nodiscard]] std::vector<std::int32_t> worst_first() const {
    std::vector<std::pair<double, std::int32_t>> order;
    for (const std::int32_t t : bad_tets()) order.emplace_back(score_(mesh_, t), t);
    std::sort(order.begin(), order.end());
    std::vector<std::int32_t> tets;
    tets.reserve(order.size());
    for (const auto& [score, t] : order) tets.push_back(t);
    return tets;
  }

  /// Works off the queue, worst first; true if anything changed.
  bool drain() {
    bool changed = false;
    for (int count = 0; !jobs_.empty(); ++count) {
      if (count % kCleanUpLimits.jobs_per_poll == 0) run_.poll();
      const Job job = jobs_.top();
      jobs_.pop();
      if (!mesh_.used(job.tet) || mesh_.stamp(job.tet) != job.stamp) continue;
      if (reconnect(job.tet) || smooth(job.tet)) changed = true;
    }
    return changed;
  }

  /// Applies the best reconnection that takes the tet out, by measure.
  bool reconnect(std::int32_t t) {
    if (!aggressive_.reconnect(t, TetQuality())) return false;
    touch(aggressive_.touched());
    return true;
  }

  bool smooth(std::int32_t t) {
    bool changed = false;
    const double enough =
        std::max(options_.threshold, mesh_.quality(t) + kCleanUpLimits.sharp_gain);
    for (const std::int32_t node : mesh_.tet(t)) {
      if (mesh_.tets_of(node).size() > kCleanUpLimits.tets_at_node || !smooth_node(node, enough))
        continue;
      changed = true;
      if (!bad(t)) break;
    }
    return changed;
  }

  bool smooth_node(std::int32_t node, double enough) {
    // Smoothing that failed fails again while the node's tets are the same and no more is asked
    // for. It is asked for often, since bad tets come in clusters.
    SmoothedInVain& vain = smoothed_in_vain_[node];
    const std::uint32_t star = mesh_.star_stamp(node);
    if (vain.star == star && enough <= vain.enough) return false;
    Vec3 position;
    if (!smoother_.smooth(node, enough, kLeastGain, position)) {
      vain = {star, enough};
      return false;
    }
    mesh_.move(node, position);
    touch(mesh_.tets_of(node));
    return true;
  }

  /// The star stamp of a node (LocalMesh::star_stamp) when smoothing it last failed, and the
  /// quality that was aimed at.
  struct SmoothedInVain {
    std::uint32_t star = 0;
    double enough = -1;
  };

  void touch(std::span<const std::int32_t> tets) {
    work_.resize(static_cast<std::size_t>(mesh_.slots()), Work::Changed);
    for (const std::int32_t t : tets) {
      if (work_[t] == Work::Same) work_[t] = is_of_input(t) ? Work::Moved : Work::Changed;
      if (bad(t)) push(t);
    }
  }
  void push(std::int32_t t) { jobs_.push({mesh_.quality(t), t, mesh_.stamp(t)}); }

  std::size_t dirty_ = 0;  ///< number of dirty tets in the input
  const TetMesh& start_;
  LocalMesh mesh_;
  BoundaryRules rules_;
  Smoother smoother_;
  ImproveOptions options_;
  const Run& run_;
  int max_ring_;
  Score score_;
  AggressiveImprovement aggressive_;
  std::vector<Work> work_;                        ///< by tet
  std::vector<SmoothedInVain> smoothed_in_vain_;  ///< by node
  std::vector<std::uint8_t> at_dirty_;  ///< by node: 1 at a dirty tet of the input, if confined
  std::priority_queue<Job, std::vector<Job>, BetterFirst> jobs_;
};

}  // namespace

ImproveResult improve(const TetMesh& mesh, std::span<const Support> supports,
                      const BoundaryModel& boundary, std::span<const std::uint8_t> dirty,
                      const ImproveOptions& options, const Run& run) {
  return CleanUp(mesh, supports, boundary, dirty, options, run).work();
}

}  // namespace remeshd
