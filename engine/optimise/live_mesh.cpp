#include "engine/optimise/live_mesh.h"

#include <numeric>

namespace remeshd {

LiveMesh::LiveMesh(const NodeSet& nodes, kernel::Delaunay start,
                   const std::vector<std::uint8_t>& holds, const Run& run)
    : mesh_(std::move(start)), count_(nodes.size()), run_(run) {
  std::vector<std::int32_t> missing;
  for (std::int32_t n = 0; n < count_; ++n)
    if (!holds[n]) missing.push_back(n);
  mesh_.insert(nodes.positions, missing, run_);
}

void LiveMesh::follow(const NodeSet& nodes) {
  std::vector<std::int32_t> all(count_);
  std::iota(all.begin(), all.end(), 0);
  if (!mesh_.move(nodes.positions, all, run_)) {
    mesh_ = mesh_.emptied();
    mesh_.insert(nodes.positions, all, run_);
  }
  std::vector<std::int32_t> added(nodes.size() - count_);
  std::iota(added.begin(), added.end(), count_);
  mesh_.insert(nodes.positions, added, run_);
  count_ = nodes.size();
}

std::vector<Tet> LiveMesh::tets() const {
  std::vector<Tet> tets;
  tets.reserve(mesh_.size());
  mesh_.for_each_tet([&](const Tet& t) { tets.push_back(t); });
  return tets;
}

}  // namespace remeshd
