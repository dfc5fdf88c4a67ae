#include "tests/campaign/verifier/tet_location.h"

#include <algorithm>
#include <cmath>

namespace remeshd::campaign {

TetLocation::TetLocation(const TetMesh& mesh) : mesh_(mesh) {
  for (const Vec3& p : mesh.nodes) box_.add(p);
  if (box_.empty()) return;
  const Vec3 size = box_.hi - box_.lo;
  cell_ = std::max(box_.diagonal() / 30, 1e-300);
  cells_ = {1 + static_cast<int>(size.x / cell_), 1 + static_cast<int>(size.y / cell_),
            1 + static_cast<int>(size.z / cell_)};
  grid_.resize(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2]);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    Box box;
    for (const std::int32_t n : mesh.tets[t]) box.add(mesh.nodes[n]);
    const auto lo = cell_of(box.lo), hi = cell_of(box.hi);
    for (int i = lo[0]; i <= hi[0]; ++i)
      for (int j = lo[1]; j <= hi[1]; ++j)
        for (int k = lo[2]; k <= hi[2]; ++k)
          grid_[(static_cast<std::size_t>(i) * cells_[1] + j) * cells_[2] + k].push_back(
              static_cast<std::int32_t>(t));
  }
}

std::array<int, 3> TetLocation::cell_of(const Vec3& p) const {
  const auto along = [&](double x, double lo, int n) {
    return std::clamp(static_cast<int>((x - lo) / cell_), 0, n - 1);
  };
  return {along(p.x, box_.lo.x, cells_[0]), along(p.y, box_.lo.y, cells_[1]),
          along(p.z, box_.lo.z, cells_[2])};
}

int TetLocation::count(const Vec3& p) const {
  if (box_.empty() || !box_.contains(p)) return 0;
  const auto [i, j, k] = cell_of(p);
  int found = 0;
  for (const std::int32_t t :
       grid_[(static_cast<std::size_t>(i) * cells_[1] + j) * cells_[2] + k]) {
    const Tet& tet = mesh_.tets[t];
    bool within = true;
    for (const auto& [a, b, c] : kTetFacets) {
      const Vec3& o = mesh_.nodes[tet[a]];
      const Vec3 n = cross(mesh_.nodes[tet[b]] - o, mesh_.nodes[tet[c]] - o);
      within = within && dot(n, p - o) <= 0;
    }
    found += within;
  }
  return found;
}

}  // namespace remeshd::campaign
