#include "engine/improve/improve.h"

#include <algorithm>
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
        dirty_(dirty.begin(), dirty.end()),
        moved_(mesh.nodes.size(), 0) {}

  ImproveResult work() {
    for (int pass = 0; pass < options_.passes; ++pass)
      if (!sweep()) break;
    ImproveResult result;
    for (std::int32_t t = 0; t < mesh_.slots(); ++t)
      if (bad(t)) ++result.below_threshold;
    result.mesh = mesh_.result();
    result.node_moved = std::move(moved_);
    return result;
  }

 private:
  [[nodiscard]] bool bad(std::int32_t t) const {
    return mesh_.used(t) && dirty_[t] != 0 && mesh_.quality(t) < options_.threshold;
  }

  /// One pass, worst first, over all bad tets; true if anything changed.
  bool sweep() {
    for (std::int32_t t = 0; t < mesh_.slots(); ++t)
      if (bad(t)) jobs_.push({mesh_.quality(t), t, mesh_.stamp(t)});
    bool changed = false;
    for (int count = 0; !jobs_.empty(); ++count) {
      if (count % 256 == 0) run_.poll();
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
    for (const std::int32_t node : mesh_.tet(t)) {
      Vec3 position;
      if (!smoother_.smooth(node, options_.threshold, kGain, position)) continue;
      mesh_.move(node, position);
      moved_[node] = 1;
      changed = true;
      for (const std::int32_t s : mesh_.tets_of(node)) touch(s);
      if (mesh_.quality(t) >= options_.threshold) break;
    }
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
