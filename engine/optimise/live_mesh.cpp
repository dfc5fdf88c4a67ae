#include "engine/optimise/live_mesh.h"

#include <algorithm>
#include <utility>

namespace remeshd {

namespace {
constexpr std::size_t kTakingOut = 3;  // x inserting a node: cost of taking one out
}

LiveMesh::LiveMesh(DelaunayMesh start, std::vector<std::uint8_t> holds, bool rebuild,
                   const Run& run)
    : mesh_(start),
      base_(std::move(start)),
      holds_(holds),
      in_base_(std::move(holds)),
      rebuild_(rebuild),
      run_(run) {}

void LiveMesh::follow(const NodeSet& nodes) {
  holds_.resize(nodes.positions.size(), 0);
  in_base_.resize(nodes.positions.size(), 0);
  std::vector<std::int32_t> held, missing;
  for (std::int32_t n = 0; n < nodes.size(); ++n) (holds_[n] ? held : missing).push_back(n);
  const bool followed = !rebuild_ && follow_held(nodes, held);
  require_patch();
  if (followed)
    mesh_.insert(nodes.positions, missing, run_);
  else
    restart(nodes);
  require_patch();
  holds_.assign(holds_.size(), 1);
}

void LiveMesh::require_patch() const {
  if (mesh_.patch_too_small()) throw PatchTooSmall{"following the nodes"};
}

bool LiveMesh::follow_held(const NodeSet& nodes, const std::vector<std::int32_t>& held) {
  const DelaunayMesh::Moved moved = mesh_.move(nodes.positions, held, run_);
  if (moved != DelaunayMesh::Moved::TooFar) return moved == DelaunayMesh::Moved::Done;
  std::vector<std::int32_t> far;
  for (const std::int32_t n : held)
    if (mesh_.position(n) != nodes.positions[n]) far.push_back(n);
  // Reinserting nodes takes them out first; a restart only inserts, but all that `base_` lacks.
  const std::size_t anew = std::count(in_base_.begin(), in_base_.end(), 0);
  return anew > kTakingOut * far.size() && mesh_.reinsert(nodes.positions, far, run_);
}

void LiveMesh::restart(const NodeSet& nodes) {
  std::vector<std::int32_t> gone;
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (in_base_[n] && base_.position(n) != nodes.positions[n]) gone.push_back(n);
  if (base_.remove(gone, run_)) {
    for (const std::int32_t n : gone) in_base_[n] = 0;
  } else {
    base_ = base_.emptied();
    in_base_.assign(in_base_.size(), 0);
  }
  std::vector<std::int32_t> others;
  for (std::int32_t n = 0; n < nodes.size(); ++n)
    if (!in_base_[n]) others.push_back(n);
  mesh_ = base_;
  mesh_.insert(nodes.positions, others, run_);
}

std::vector<Tet> LiveMesh::tets() const {
  std::vector<Tet> tets;
  tets.reserve(mesh_.size());
  mesh_.for_each_tet([&](const Tet& t) { tets.push_back(t); });
  return tets;
}

std::vector<Tet> LiveMesh::tets_at(const std::vector<std::uint8_t>& at) const {
  std::vector<Tet> tets;
  mesh_.for_each_tet([&](const Tet& t) {
    if (at[t[0]] | at[t[1]] | at[t[2]] | at[t[3]]) tets.push_back(t);
  });
  return tets;
}

}  // namespace remeshd
