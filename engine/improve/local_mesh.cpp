#include "engine/improve/local_mesh.h"

#include <algorithm>
#include <cassert>

#include "engine/mesh/quality.h"

namespace remeshd {
namespace {

/// Room for a node's list to grow before it must be moved.
constexpr std::int32_t kSlack = 6;

bool has(const Tet& tet, std::int32_t n) {
  return tet[0] == n || tet[1] == n || tet[2] == n || tet[3] == n;
}

/// The other two nodes of a tet with the edge a-b, ordered so that (a, b, x, y) is positive.
std::array<std::int32_t, 2> opposite_edge(const Tet& tet, std::int32_t a, std::int32_t b) {
  // For corners i and j the other two in the order that makes an even permutation.
  constexpr std::int8_t kOther[4][4][2] = {{{0, 0}, {2, 3}, {3, 1}, {1, 2}},
                                           {{3, 2}, {0, 0}, {0, 3}, {2, 0}},
                                           {{1, 3}, {3, 0}, {0, 0}, {0, 1}},
                                           {{2, 1}, {0, 2}, {1, 0}, {0, 0}}};
  int i = 0;
  int j = 0;
  for (int k = 1; k < 4; ++k) {
    if (tet[k] == a) i = k;
    if (tet[k] == b) j = k;
  }
  return {tet[kOther[i][j][0]], tet[kOther[i][j][1]]};
}

}  // namespace

LocalMesh::LocalMesh(const TetMesh& mesh, std::int32_t locked, const Run& run)
    : locked_(locked),
      nodes_(mesh.nodes),
      tets_(mesh.tets),
      qualities_(mesh.tets.size(), kUnknown),
      stamps_(mesh.tets.size(), 0),
      star_stamps_(mesh.nodes.size(), 0),
      lists_(mesh.nodes.size()) {
  Polling poll(run);
  for (const Tet& tet : tets_) {
    poll();
    for (const std::int32_t n : tet) ++lists_[n].capacity;
  }
  std::int32_t begin = 0;
  for (List& list : lists_) {
    list.begin = begin;
    list.capacity += kSlack;
    begin += list.capacity;
  }
  pool_.resize(static_cast<std::size_t>(begin));
  for (std::int32_t t = 0; t < slots(); ++t) {
    poll();
    for (const std::int32_t n : tets_[t]) pool_[lists_[n].begin + lists_[n].size++] = t;
  }
}

double LocalMesh::quality(std::int32_t t) const {
  double& q = qualities_[t];
  if (q == kUnknown) q = volume_length(nodes_, tets_[t]);
  return q;
}

std::int32_t LocalMesh::across(std::int32_t t, std::int32_t a, std::int32_t b,
                               std::int32_t c) const {
  for (const std::int32_t s : tets_of(a))
    if (s != t && has(tets_[s], b) && has(tets_[s], c)) return s;
  return -1;
}

bool LocalMesh::joined(std::int32_t a, std::int32_t b) const {
  for (const std::int32_t s : tets_of(a))
    if (has(tets_[s], b)) return true;
  return false;
}

bool LocalMesh::ring(std::int32_t a, std::int32_t b, int max_tets, EdgeRing& out) const {
  assert(max_tets <= EdgeRing::kMaxTets);
  std::array<std::int32_t, EdgeRing::kMaxTets> found{};
  std::array<std::int32_t, EdgeRing::kMaxTets> from{};
  std::array<std::int32_t, EdgeRing::kMaxTets> to{};
  int count = 0;
  for (const std::int32_t s : tets_of(a)) {
    if (!has(tets_[s], b)) continue;
    if (count == max_tets) return false;
    const auto [x, y] = opposite_edge(tets_[s], a, b);
    found[count] = s;
    from[count] = x;
    to[count] = y;
    ++count;
  }
  if (count == 0) return false;
  // An open ring begins at the node that no tet turns to, a closed one at its first tet.
  int at = 0;
  for (int i = 0; i < count; ++i) {
    if (std::find(to.begin(), to.begin() + count, from[i]) == to.begin() + count) {
      at = i;
      break;
    }
  }
  out.tets = 0;
  out.nodes = 0;
  out.node[out.nodes++] = from[at];
  while (true) {
    out.tet[out.tets++] = found[at];
    const std::int32_t next = to[at];
    out.closed = next == out.node[0];
    if (!out.closed) out.node[out.nodes++] = next;
    if (out.closed || out.tets == count) break;
    const auto* const p = std::find(from.begin(), from.begin() + count, next);
    if (p == from.begin() + count) return false;
    at = static_cast<int>(p - from.begin());
  }
  return out.tets == count;
}

void LocalMesh::replace(std::span<const std::int32_t> old_tets, std::span<const Tet> fresh,
                        std::vector<std::int32_t>& slots) {
  const std::size_t first = slots.size();
  Change change;
  if (on_trial_) {
    change.slots = this->slots();
    change.old_slots.assign(old_tets.begin(), old_tets.end());
    for (const std::int32_t t : old_tets) change.old_tets.push_back(tets_[t]);
  }
  for (const std::int32_t t : old_tets) {
    for (const std::int32_t n : tets_[t]) unlink(n, t);
    tets_[t][0] = -1;
    ++stamps_[t];
  }
  gaps_.insert(gaps_.end(), old_tets.rbegin(), old_tets.rend());
  for (const Tet& tet : fresh) {
    std::int32_t t = 0;
    if (gaps_.empty()) {
      t = this->slots();
      tets_.emplace_back();
      qualities_.push_back(kUnknown);
      stamps_.push_back(0);
    } else {
      t = gaps_.back();
      gaps_.pop_back();
      qualities_[t] = kUnknown;
      ++stamps_[t];
    }
    tets_[t] = tet;
    for (const std::int32_t n : tet) link(n, t);
    slots.push_back(t);
  }
  if (on_trial_) {
    change.fresh_slots.assign(slots.begin() + static_cast<std::ptrdiff_t>(first), slots.end());
    changes_.push_back(std::move(change));
  }
}

void LocalMesh::move(std::int32_t node, const Vec3& position) {
  if (on_trial_) {
    Change change;
    change.node = node;
    change.position = nodes_[node];
    changes_.push_back(std::move(change));
  }
  set_position(node, position, 1);
}

void LocalMesh::begin_trial() {
  assert(!on_trial_);
  on_trial_ = true;
}

void LocalMesh::keep_trial() {
  on_trial_ = false;
  changes_.clear();
}

void LocalMesh::undo_trial() {
  for (auto change = changes_.rbegin(); change != changes_.rend(); ++change) take_back(*change);
  keep_trial();
}

void LocalMesh::take_back(const Change& change) {
  if (change.node >= 0) return set_position(change.node, change.position, -1);
  for (auto t = change.fresh_slots.rbegin(); t != change.fresh_slots.rend(); ++t) {
    for (const std::int32_t n : tets_[*t]) unlink(n, *t);
    tets_[*t][0] = -1;
    --stamps_[*t];
    if (*t < change.slots) gaps_.push_back(*t);
  }
  tets_.resize(change.slots);
  qualities_.resize(change.slots);
  stamps_.resize(change.slots);
  gaps_.resize(gaps_.size() - change.old_slots.size());
  for (std::size_t i = 0; i < change.old_slots.size(); ++i) {
    const std::int32_t t = change.old_slots[i];
    tets_[t] = change.old_tets[i];
    qualities_[t] = kUnknown;
    --stamps_[t];
    for (const std::int32_t n : tets_[t]) link(n, t);
  }
}

/// Adds `stamps` to the stamp of every tet at the node, and to the star stamps of these tets'
/// nodes.
void LocalMesh::set_position(std::int32_t node, const Vec3& position, std::int32_t stamps) {
  nodes_[node] = position;
  for (const std::int32_t t : tets_of(node)) {
    qualities_[t] = kUnknown;
    stamps_[t] += stamps;
    for (const std::int32_t n : tets_[t]) star_stamps_[n] += stamps;
  }
}

TetMesh LocalMesh::result() const {
  TetMesh mesh;
  mesh.nodes = nodes_;
  mesh.tets.reserve(tets_.size());
  for (const Tet& tet : tets_)
    if (tet[0] >= 0) mesh.tets.push_back(tet);
  return mesh;
}

void LocalMesh::link(std::int32_t node, std::int32_t t) {
  ++star_stamps_[node];
  List& list = lists_[node];
  if (list.size == list.capacity) {
    const auto moved = static_cast<std::int32_t>(pool_.size());
    list.capacity = 2 * list.capacity + kSlack;
    pool_.resize(pool_.size() + static_cast<std::size_t>(list.capacity));
    std::copy_n(pool_.begin() + list.begin, list.size, pool_.begin() + moved);
    list.begin = moved;
  }
  pool_[list.begin + list.size++] = t;
}

void LocalMesh::unlink(std::int32_t node, std::int32_t t) {
  ++star_stamps_[node];
  List& list = lists_[node];
  const auto begin = pool_.begin() + list.begin;
  const auto it = std::find(begin, begin + list.size, t);
  assert(it != begin + list.size);
  *it = *(begin + list.size - 1);
  --list.size;
}

}  // namespace remeshd
