#include "engine/improve/improve.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "engine/improve/boundary_rules.h"
#include "engine/improve/local_mesh.h"
#include "engine/improve/reconnect.h"
#include "engine/improve/smooth.h"
#include "engine/mesh/quality.h"

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
constexpr int kClimbRounds = 4;
constexpr double kLeastGain = 1e-4;  // of the score, for a step of a climb: it bounds their number
constexpr double kClimbStep = 0.1, kLeastClimb = 0.004;  // of the local edge length

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
        if (!bad(t) || !(relax(t) || reconnect_by_score(t) || climb(t))) continue;
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

  using Corners = std::array<Vec3, 4>;

  [[nodiscard]] Corners corners(const Tet& tet) const {
    return {mesh_.node(tet[0]), mesh_.node(tet[1]), mesh_.node(tet[2]), mesh_.node(tet[3])};
  }
  /// Of the tet with one of its nodes at p.
  [[nodiscard]] Corners corners(std::int32_t t, std::int32_t node, const Vec3& p) const {
    Corners c = corners(mesh_.tet(t));
    for (int i = 0; i < 4; ++i)
      if (mesh_.tet(t)[i] == node) c[i] = p;
    return c;
  }

  /// How near a tet comes to being good enough in measure and in angle: 1 where it is.
  [[nodiscard]] double score(const Corners& c) const {
    const double quality = volume_length(c[0], c[1], c[2], c[3]);
    double s = std::min(1.0, quality / options_.threshold);
    if (quality > 0 && quality < kNeverSharp)
      s = std::min(s, (1 - sharpest_cosine(c[0], c[1], c[2], c[3])) / (1 - max_cosine_));
    return s;
  }
  [[nodiscard]] double score(const Tet& tet) const { return score(corners(tet)); }
  [[nodiscard]] double score(std::int32_t t) const { return score(mesh_.tet(t)); }

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

  /// Applies the best reconnection that takes the tet out, by measure.
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
    if (found) apply_best();
    return found;
  }

  void apply_best() {
    slots_.clear();
    mesh_.replace(best_.old_tets, best_.fresh, slots_);
    dirty_.resize(static_cast<std::size_t>(mesh_.slots()), 1);
    for (const std::int32_t s : slots_) touch(s);
  }

  /// Applies the reconnection that takes the tet out and has the best worst score, angles counted:
  /// the tet may be of a fair measure and sharp.
  bool reconnect_by_score(std::int32_t t) {
    const Tet tet = mesh_.tet(t);
    bool found = false;
    double best = 0;
    const auto consider = [&] {
      double before = 1, after = 1;
      for (const std::int32_t old : trial_.old_tets) before = std::min(before, score(old));
      for (const Tet& fresh : trial_.fresh) after = std::min(after, score(fresh));
      if (after < before + kGain || after <= best) return;
      std::swap(trial_, best_);
      best = after;
      found = true;
    };
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        if (remove_edge(mesh_, rules_, tet[i], tet[j], max_ring_, 0, trial_)) consider();
    for (int i = 0; i < 4; ++i)
      if (remove_faces(mesh_, t, i, 0, trial_)) consider();
    if (found) apply_best();
    return found;
  }

  /// Moves the tet's nodes, one after the other, in shrinking steps along the axes wherever the
  /// worst score of the node's tets gets better.
  bool climb(std::int32_t t) {
    bool changed = false;
    for (int round = 0; round < kClimbRounds && bad(t); ++round) {
      bool moved = false;
      for (const std::int32_t node : Tet(mesh_.tet(t))) moved |= climb_node(node);
      if (!moved) break;
      changed = true;
    }
    if (changed)
      for (const std::int32_t node : Tet(mesh_.tet(t)))
        for (const std::int32_t s : mesh_.tets_of(node)) touch(s);
    return changed;
  }

  bool climb_node(std::int32_t node) {
    if (!rules_.facets_at(node, facets_)) return false;
    const auto at = mesh_.tets_of(node);
    double length = 0;
    for (const std::int32_t n : mesh_.tet(at[0]))
      length = std::max(length, distance(mesh_.node(n), mesh_.node(node)));
    const auto worst = [&](const Vec3& p, double floor) {
      double s = 1;
      for (const std::int32_t other : mesh_.tets_of(node)) {
        s = std::min(s, score(corners(other, node, p)));
        if (s <= floor) break;
      }
      return s;
    };
    const Vec3 start = mesh_.node(node);
    Vec3 place = start;
    double reached = worst(start, -1);
    const double before = reached;
    for (double step = kClimbStep * length; step > kLeastClimb * length && reached < 1;) {
      Vec3 best = place;
      for (int k = 0; k < 6; ++k) {
        Vec3 towards{};
        (k / 2 == 0 ? towards.x : k / 2 == 1 ? towards.y : towards.z) = k % 2 ? -step : step;
        const Vec3 p = rules_.settle(node, place + towards);
        const double s = worst(p, reached + kLeastGain);
        if (s <= reached + kLeastGain || (!facets_.empty() && !rules_.may_move(node, p, facets_)))
          continue;
        reached = s;
        best = p;
      }
      if (best == place)
        step *= 0.5;
      else
        place = best;
    }
    if (reached < before + kGain) return false;
    mesh_.move(node, place);
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
  std::vector<Triangle> facets_;
};

}  // namespace

ImproveResult improve(const TetMesh& mesh, std::span<const Support> supports,
                      const BoundaryModel& boundary, std::span<const std::uint8_t> dirty,
                      const ImproveOptions& options, const Run& run) {
  return CleanUp(mesh, supports, boundary, dirty, options, run).work();
}

}  // namespace remeshd
