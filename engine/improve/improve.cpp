#include "engine/improve/improve.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "engine/improve/boundary_rules.h"
#include "engine/improve/local_mesh.h"
#include "engine/improve/reconnect.h"
#include "engine/improve/smooth.h"

namespace remeshd {
namespace {

/// Least gain of the worst quality for which a reconnection or a move is worth while; it also
/// bounds the number of operations.
constexpr double kGain = 1e-3;
/// Tets of this measure and above have no dihedral angle that one asks to remove.
constexpr double kNeverSharp = 0.7;
/// By how much a move tries to raise a tet at least; a sharp one may be above the threshold
/// already.
constexpr double kSharpGain = 0.02;
/// Rounds of easing over the nodes at a stubborn tet's neighbours.
constexpr int kRelaxRounds = 12;
/// So many tets per pass are relaxed at most, and one more per thousand: a VTM mesh of 15,000 nodes
/// has fewer than ten, only a threshold out of reach has more.
constexpr std::size_t kMostStubborn = 40;
constexpr int kPollEvery = 64;

/// Cosine of a positive tet's smallest dihedral angle.
double sharpest_cosine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<Vec3, 4> normal{cross(c - b, d - b), cross(d - a, c - a), cross(b - a, d - a),
                                   cross(c - a, b - a)};
  std::array<double, 4> scale{};
  for (int i = 0; i < 4; ++i) scale[i] = 1 / norm(normal[i]);
  double cosine = -1;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      cosine = std::max(cosine, -dot(normal[i], normal[j]) * scale[i] * scale[j]);
  return cosine;
}

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

/// How a group of tets does by their scores.
struct Standing {
  double worst = 1;
  double lacking = 0;  ///< what the scores lack to 1, summed
  void add(double score) {
    worst = std::min(worst, score);
    lacking += 1 - score;
  }
};

class CleanUp {
 public:
  CleanUp(const TetMesh& mesh, std::span<const Support> supports, const BoundaryModel& boundary,
          std::span<const std::uint8_t> dirty, const ImproveOptions& options, const Run& run)
      : start_(mesh.nodes),
        mesh_(mesh, run),
        rules_(boundary, supports, mesh_, options.chord_tolerance),
        smoother_(mesh_, rules_),
        options_(options),
        run_(run),
        max_ring_(std::clamp(options.max_ring, 3, EdgeRing::kMaxTets)),
        max_cosine_(std::cos(options.min_dihedral)),
        dirty_(dirty.begin(), dirty.end()) {}

  ImproveResult work() {
    for (int pass = 0; pass < options_.passes; ++pass) {
      for (const std::int32_t t : bad_tets()) push(t);
      bool changed = drain();
      for (const std::int32_t t : stubborn_tets()) {
        run_.poll();
        if (!bad(t) || !relax(t)) continue;
        drain();
        changed = true;
      }
      if (!changed) break;
    }
    ImproveResult result;
    result.below_threshold = static_cast<std::uint32_t>(bad_tets().size());
    result.mesh = mesh_.result();
    result.node_moved.resize(start_.size());
    for (std::size_t n = 0; n < start_.size(); ++n)
      result.node_moved[n] = result.mesh.nodes[n] != start_[n] ? 1 : 0;
    return result;
  }

 private:
  [[nodiscard]] bool bad(std::int32_t t) const {
    if (!mesh_.used(t) || dirty_[t] == 0) return false;
    const double quality = mesh_.quality(t);
    return quality < options_.threshold || (quality < kNeverSharp && sharpness(t) > max_cosine_);
  }

  [[nodiscard]] double sharpness(std::int32_t t) const {
    const Tet& tet = mesh_.tet(t);
    return sharpest_cosine(mesh_.node(tet[0]), mesh_.node(tet[1]), mesh_.node(tet[2]),
                           mesh_.node(tet[3]));
  }

  /// How near a tet comes to being good enough in measure and in angle: 1 where it is.
  [[nodiscard]] double score(std::int32_t t) const {
    const double quality = mesh_.quality(t);
    double s = std::min(1.0, quality / options_.threshold);
    if (quality > 0 && quality < kNeverSharp)
      s = std::min(s, (1 - sharpness(t)) / (1 - max_cosine_));
    return s;
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

  /// The worst of the bad tets: few enough for the dear treatment that they get.
  [[nodiscard]] std::vector<std::int32_t> stubborn_tets() const {
    std::vector<std::pair<double, std::int32_t>> order;
    for (const std::int32_t t : bad_tets()) order.emplace_back(score(t), t);
    std::sort(order.begin(), order.end());
    const std::size_t most = kMostStubborn + static_cast<std::size_t>(mesh_.slots()) / 1000;
    std::vector<std::int32_t> tets;
    for (std::size_t i = 0; i < std::min(most, order.size()); ++i) tets.push_back(order[i].second);
    return tets;
  }

  /// Works off the queue, worst first; true if anything changed.
  bool drain() {
    bool changed = false;
    for (int count = 0; !jobs_.empty(); ++count) {
      if (count % kPollEvery == 0) run_.poll();
      const Job job = jobs_.top();
      jobs_.pop();
      if (!mesh_.used(job.tet) || mesh_.stamp(job.tet) != job.stamp) continue;
      if (reconnect(job.tet) || smooth(job.tet)) changed = true;
    }
    return changed;
  }

  /// Applies the best reconnection that takes the tet out.
  bool reconnect(std::int32_t t) {
    const Tet tet = mesh_.tet(t);
    const double quality = mesh_.quality(t);
    double floor = quality + kGain;
    bool found = false;
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        if (!remove_edge(mesh_, rules_, tet[i], tet[j], max_ring_, floor, trial_)) continue;
        std::swap(trial_, best_);
        floor = best_.quality;
        found = true;
      }
    }
    for (int i = 0; i < 4; ++i) {
      if (!remove_faces(mesh_, t, i, floor, trial_)) continue;
      std::swap(trial_, best_);
      floor = best_.quality;
      found = true;
    }
    if (!found) return false;
    slots_.clear();
    mesh_.replace(best_.old_tets, best_.fresh, slots_);
    dirty_.resize(static_cast<std::size_t>(mesh_.slots()), 1);
    for (const std::int32_t s : slots_) touch(s);
    return true;
  }

  bool smooth(std::int32_t t) {
    bool changed = false;
    const double enough = std::max(options_.threshold, mesh_.quality(t) + kSharpGain);
    for (const std::int32_t node : mesh_.tet(t)) {
      if (!smooth_node(node, enough)) continue;
      changed = true;
      if (!bad(t)) break;
    }
    return changed;
  }

  bool smooth_node(std::int32_t node, double enough) {
    Vec3 position;
    if (!smoother_.smooth(node, enough, kGain, position)) return false;
    mesh_.move(node, position);
    for (const std::int32_t s : mesh_.tets_of(node)) touch(s);
    return true;
  }

  /// Moves all nodes round a tet a little, several times, though most of their tets are good
  /// enough: where two nodes of a model edge are too near, each holds the other. Takes the moves
  /// back unless all tets that they touch get better taken together, and the worst no worse.
  bool relax(std::int32_t t) {
    std::vector<std::int32_t> nodes;
    for (const std::int32_t node : mesh_.tet(t))
      for (const std::int32_t s : mesh_.tets_of(node))
        nodes.insert(nodes.end(), mesh_.tet(s).begin(), mesh_.tet(s).end());
    sort_unique(nodes);
    std::vector<std::int32_t> tets;
    for (const std::int32_t node : nodes)
      tets.insert(tets.end(), mesh_.tets_of(node).begin(), mesh_.tets_of(node).end());
    sort_unique(tets);
    const auto standing = [&] {
      Standing now;
      for (const std::int32_t other : tets) now.add(score(other));
      return now;
    };
    const Standing before = standing();
    std::vector<Vec3> places;
    for (const std::int32_t node : nodes) places.push_back(mesh_.node(node));
    Standing after = before;
    for (int round = 0; round < kRelaxRounds && after.lacking > 0; ++round) {
      for (const std::int32_t node : nodes) {
        Vec3 position;
        if (smoother_.ease(node, position)) mesh_.move(node, position);
      }
      after = standing();
    }
    if (after.worst >= before.worst && after.lacking < before.lacking - kGain) {
      for (const std::int32_t other : tets) touch(other);
      return true;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (mesh_.node(nodes[i]) != places[i]) mesh_.move(nodes[i], places[i]);
    return false;
  }

  static void sort_unique(std::vector<std::int32_t>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  void touch(std::int32_t t) {
    dirty_[t] = 1;
    if (bad(t)) push(t);
  }
  void push(std::int32_t t) { jobs_.push({mesh_.quality(t), t, mesh_.stamp(t)}); }

  const std::vector<Vec3>& start_;  ///< where the nodes were
  LocalMesh mesh_;
  BoundaryRules rules_;
  Smoother smoother_;
  ImproveOptions options_;
  const Run& run_;
  int max_ring_;
  double max_cosine_;  ///< of the smallest dihedral angle that is good enough
  std::vector<std::uint8_t> dirty_;
  std::priority_queue<Job, std::vector<Job>, BetterFirst> jobs_;
  Reconnection trial_, best_;
  std::vector<std::int32_t> slots_;
};

}  // namespace

ImproveResult improve(const TetMesh& mesh, std::span<const Support> supports,
                      const BoundaryModel& boundary, std::span<const std::uint8_t> dirty,
                      const ImproveOptions& options, const Run& run) {
  return CleanUp(mesh, supports, boundary, dirty, options, run).work();
}

}  // namespace remeshd
