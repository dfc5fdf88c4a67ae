#include <algorithm>

#include "engine/improve/reconnect.h"

namespace remeshd {
namespace {

constexpr int kMaxNodes = EdgeRing::kMaxTets + 1;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Best triangulations of the polygon of a ring and of all its sub-polygons i..j.
class RingTriangulation {
 public:
  RingTriangulation(const LocalMesh& mesh, std::int32_t a, std::int32_t b, const EdgeRing& ring,
                    double floor, const TetQuality& quality)
      : quality_(quality), a_(mesh.node(a)), b_(mesh.node(b)), count_(ring.nodes) {
    for (int i = 0; i < count_; ++i) points_[i] = mesh.node(ring.node[i]);
    for (int i = 0; i + 1 < count_; ++i) best_[i][i + 1] = kInfinity;
    for (int span = 2; span < count_; ++span)
      for (int i = 0; i + span < count_; ++i) solve(i, i + span, floor);
  }

  [[nodiscard]] double quality() const { return best_[0][count_ - 1]; }

  void triangles(int i, int j, std::vector<std::array<int, 3>>& out) const {
    if (j - i < 2) return;
    const int k = apex_[i][j];
    triangles(i, k, out);
    triangles(k, j, out);
    out.push_back({i, k, j});
  }

 private:
  void solve(int i, int j, double floor) {
    double best = -kInfinity;
    for (int k = i + 1; k < j; ++k) {
      double q = std::min(best_[i][k], best_[k][j]);
      // What is not above the floor, or not above what is found already, needs no tets measured.
      if (q <= std::max(best, floor)) continue;
      q = std::min(q, quality_(a_, points_[i], points_[k], points_[j]));
      if (q <= std::max(best, floor)) continue;
      q = std::min(q, quality_(b_, points_[i], points_[j], points_[k]));
      if (q <= std::max(best, floor)) continue;
      best = q;
      apex_[i][j] = k;
    }
    best_[i][j] = best;
  }

  const TetQuality& quality_;
  Vec3 a_, b_;
  int count_;
  std::array<Vec3, kMaxNodes> points_;
  std::array<std::array<double, kMaxNodes>, kMaxNodes> best_;
  std::array<std::array<int, kMaxNodes>, kMaxNodes> apex_;
};

}  // namespace

bool remove_edge(const LocalMesh& mesh, const BoundaryRules& rules, std::int32_t a, std::int32_t b,
                 int max_ring, double floor, Reconnection& out, const TetQuality& quality) {
  EdgeRing ring;
  if ((mesh.locked(a) && mesh.locked(b)) || !mesh.ring(a, b, max_ring, ring)) return false;
  double worst = kInfinity;
  for (int i = 0; i < ring.tets; ++i) worst = std::min(worst, quality(mesh, ring.tet[i]));
  floor = std::max(floor, worst);
  if (ring.closed ? ring.nodes < 3 : !rules.may_swap(a, b, ring)) return false;

  const RingTriangulation triangulation(mesh, a, b, ring, floor, quality);
  if (!(triangulation.quality() > floor)) return false;
  out.clear();
  out.quality = triangulation.quality();
  out.old_tets.assign(ring.tet.begin(), ring.tet.begin() + ring.tets);
  std::vector<std::array<int, 3>> triangles;
  triangulation.triangles(0, ring.nodes - 1, triangles);
  for (const auto& [i, k, j] : triangles) {
    out.fresh.push_back({a, ring.node[i], ring.node[k], ring.node[j]});
    out.fresh.push_back({b, ring.node[i], ring.node[j], ring.node[k]});
  }
  return true;
}

}  // namespace remeshd
