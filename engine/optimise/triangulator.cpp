#include "engine/optimise/triangulator.h"

namespace remeshd {

Triangulator::Triangulator(const NodeSet& nodes, kernel::Delaunay mesh,
                           std::vector<std::uint8_t> holds, const Run& run)
    : empty_(mesh.emptied()), fixed_(std::move(mesh)), holds_(std::move(holds)), run_(run) {
  update(nodes);
}

void Triangulator::update(const NodeSet& nodes) {
  holds_.resize(nodes.positions.size(), 0);
  std::vector<std::int32_t> freed, fixed;
  for (std::int32_t n = 0; n < nodes.size(); ++n) {
    if (holds_[n] && nodes.free[n]) freed.push_back(n);
    if (!holds_[n] && !nodes.free[n]) fixed.push_back(n);
  }
  if (!fixed_.remove(freed, run_)) {
    fixed_ = empty_;
    fixed.clear();
    for (std::int32_t n = 0; n < nodes.size(); ++n)
      if (!nodes.free[n]) fixed.push_back(n);
  }
  fixed_.insert(nodes.positions, fixed, run_);
  for (std::int32_t n = 0; n < nodes.size(); ++n) holds_[n] = !nodes.free[n];
}

kernel::Delaunay Triangulator::complete(const NodeSet& nodes) const {
  kernel::Delaunay mesh = fixed_;
  std::vector<std::int32_t> free;
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (nodes.free[n]) free.push_back(n);
  mesh.insert(nodes.positions, free, run_);
  return mesh;
}

std::vector<Tet> tets_of(const kernel::Delaunay& mesh) {
  std::vector<Tet> tets;
  tets.reserve(mesh.size());
  mesh.for_each_tet([&](const Tet& t) { tets.push_back(t); });
  return tets;
}

}  // namespace remeshd
