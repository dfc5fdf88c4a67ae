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
/// How far above the threshold the neighbours of a stubborn tet are raised.
constexpr double kRelaxed = 0.15;

/// Whether a positive tet has a dihedral angle whose cosine is above `cosine`.
bool sharper(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double cosine) {
  const std::array<Vec3, 4> normal{cross(c - b, d - b), cross(d - a, c - a), cross(b - a, d - a),
                                   cross(c - a, b - a)};
  std::array<double, 4> length{};
  for (int i = 0; i < 4; ++i) length[i] = norm(normal[i]);
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      if (-dot(normal[i], normal[j]) > cosine * length[i] * length[j]) return true;
  return false;
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

class CleanUp {
 public:
  CleanUp(const TetMesh& mesh, std::span<const Support> supports, const BoundaryModel& boundary,
          std::span<const std::uint8_t> dirty, const ImproveOptions& options, const Run& run)
      : mesh_(mesh),
        rules_(boundary, supports, mesh_, options.chord_tolerance),
        smoother_(mesh_, rules_),
        options_(options),
        run_(run),
        max_ring_(std::clamp(options.max_ring, 3, EdgeRing::kMaxTets)),
        max_cosine_(std::cos(options.min_dihedral)),
        dirty_(dirty.begin(), dirty.end()),
        moved_(mesh.nodes.size(), 0) {}

  ImproveResult work() {
    for (int pass = 0; pass < options_.passes; ++pass)
      if (!sweep(pass > 0)) break;
    ImproveResult result;
    for (std::int32_t t = 0; t < mesh_.slots(); ++t)
      if (bad(t)) ++result.below_threshold;
    result.mesh = mesh_.result();
    result.node_moved = std::move(moved_);
    return result;
  }

 private:
  [[nodiscard]] bool bad(std::int32_t t) const {
    if (!mesh_.used(t) || dirty_[t] == 0) return false;
    const double quality = mesh_.quality(t);
    return quality < options_.threshold || (quality < kNeverSharp && sharp(t));
  }

  [[nodiscard]] bool sharp(std::int32_t t) const {
    const Tet& tet = mesh_.tet(t);
    return sharper(mesh_.node(tet[0]), mesh_.node(tet[1]), mesh_.node(tet[2]), mesh_.node(tet[3]),
                   max_cosine_);
  }

  /// One pass, worst first, over all bad tets; true if anything changed. A thorough one makes room
  /// round tets on which nothing else works.
  bool sweep(bool thorough) {
    for (std::int32_t t = 0; t < mesh_.slots(); ++t)
      if (bad(t)) jobs_.push({mesh_.quality(t), t, mesh_.stamp(t)});
    bool changed = false;
    for (int count = 0; !jobs_.empty(); ++count) {
      if (count % 256 == 0) run_.poll();
      const Job job = jobs_.top();
      jobs_.pop();
      if (!mesh_.used(job.tet) || mesh_.stamp(job.tet) != job.stamp) continue;
      if (reconnect(job.tet) || smooth(job.tet) || (thorough && relax(job.tet))) changed = true;
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
    moved_[node] = 1;
    for (const std::int32_t s : mesh_.tets_of(node)) touch(s);
    return true;
  }

  /// Moves the nodes round a tet apart, though their own tets are good enough, so that the tet's
  /// nodes get room: where two nodes of a model edge are too near, each holds the other.
  bool relax(std::int32_t t) {
    std::vector<std::int32_t> nodes;
    for (const std::int32_t node : mesh_.tet(t))
      for (const std::int32_t s : mesh_.tets_of(node))
        nodes.insert(nodes.end(), mesh_.tet(s).begin(), mesh_.tet(s).end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    bool changed = false;
    for (const std::int32_t node : nodes)
      if (smooth_node(node, options_.threshold + kRelaxed)) changed = true;
    return changed;
  }

  void touch(std::int32_t t) {
    dirty_[t] = 1;
    if (bad(t)) jobs_.push({mesh_.quality(t), t, mesh_.stamp(t)});
  }

  LocalMesh mesh_;
  BoundaryRules rules_;
  Smoother smoother_;
  ImproveOptions options_;
  const Run& run_;
  int max_ring_;
  double max_cosine_;  ///< of the smallest dihedral angle that is good enough
  std::vector<std::uint8_t> dirty_;
  std::vector<std::uint8_t> moved_;
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
