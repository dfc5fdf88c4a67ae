// Inserting nodes that were moved as a rigid body, together with their tets.
#include <algorithm>

#include "engine/delaunay/delaunay_mesh.h"
#include "engine/kernel/predicates.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

namespace {
constexpr std::size_t kFewNodes = 200;  // of a block: finding its place does not pay for fewer
}

void DelaunayMesh::insert_moved(const DelaunayMesh& from, std::span<const std::int32_t> names,
                                std::span<const Vec3> positions, const Run& run) {
  const RigidBlock block = rigid_block_of(from, names);
  std::vector<std::uint8_t> inner(names.size(), 0);
  for (const std::int32_t n : block.nodes) inner[n] = 1;
  std::vector<std::int32_t> rest, within;
  std::int32_t count = static_cast<std::int32_t>(points_.size()) - kSuper;
  for (std::size_t n = 0; n < names.size(); ++n) {
    if (names[n] < 0) continue;
    (inner[n] ? within : rest).push_back(names[n]);
    count = std::max(count, names[n] + 1);
  }
  points_.resize(static_cast<std::size_t>(count) + kSuper);
  insert(positions, rest, run);
  for (const std::int32_t n : within) points_[n + kSuper] = positions[n];
  if (patch_too_small_ || within.empty() || transplant(from, block, names, run)) return;
  insert(positions, within, run);
}

DelaunayMesh::RigidBlock DelaunayMesh::rigid_block_of(const DelaunayMesh& from,
                                                      std::span<const std::int32_t> names) {
  RigidBlock block;
  const auto name = [&](std::int32_t v) { return v < kSuper ? -1 : names[v - kSuper]; };
  // Inner nodes: each of their tets has only nodes that come, and a tet across each of its facets.
  std::vector<std::uint8_t> inner(from.points_.size(), 0);
  for (std::size_t v = kSuper; v < inner.size(); ++v)
    inner[v] = name(static_cast<std::int32_t>(v)) >= 0 ? 1 : 0;
  for (const Slot& s : from.slots_) {
    if (s.v[0] == kDead) continue;
    const auto comes = [&](int i) { return name(s.v[i]) >= 0 && s.n[i].is_tet(); };
    if (comes(0) && comes(1) && comes(2) && comes(3)) continue;
    for (const std::int32_t v : s.v) inner[v] = 0;
  }
  block.number.assign(from.slots_.size(), -1);
  for (std::size_t t = 0; t < from.slots_.size(); ++t) {
    const auto& v = from.slots_[t].v;
    if (v[0] == kDead || !(inner[v[0]] | inner[v[1]] | inner[v[2]] | inner[v[3]])) continue;
    block.number[t] = static_cast<std::int32_t>(block.tets.size());
    block.tets.push_back(static_cast<std::int32_t>(t));
  }
  std::vector<std::uint8_t> met(from.points_.size(), 0);
  for (const std::int32_t t : block.tets)
    for (const std::int32_t v : from.slots_[t].v) met[v] = inner[v];
  for (std::size_t v = kSuper; v < met.size(); ++v)
    if (met[v]) block.nodes.push_back(static_cast<std::int32_t>(v) - kSuper);
  if (block.nodes.size() < kFewNodes) return {};
  for (std::size_t k = 0; k < block.tets.size(); ++k) {
    const Slot& s = from.slots_[block.tets[k]];
    for (int i = 0; i < 4; ++i) {
      if (block.number[s.n[i].tet()] >= 0) continue;
      const auto& f = kTetFacets[i];
      const std::int32_t a = name(s.v[f[0]]) + kSuper, b = name(s.v[f[1]]) + kSuper,
                         c = name(s.v[f[2]]) + kSuper;
      block.facets.push_back(
          {HoleFacet::key_of(a, b, c), {static_cast<std::int32_t>(k), i}, {a, c, b}});
    }
  }
  std::sort(block.facets.begin(), block.facets.end());
  return block;
}

bool DelaunayMesh::transplant(const DelaunayMesh& from, const RigidBlock& block,
                              std::span<const std::int32_t> names, const Run& run) {
  const std::optional<std::vector<Fill>> fill = match_hole(*this, block.facets, run);
  if (!fill) return false;
  std::vector<std::uint8_t> at_facet(points_.size(), 0);
  for (const HoleFacet& facet : block.facets)
    for (const std::int32_t v : facet.v) at_facet[v] = 1;
  for (const Fill& f : *fill)
    for (const std::int32_t v : slots_[f.tet].v)
      if (at_facet[v] == 0) return false;  // a node inside of the block, which would be in no tet
  // `outer`: by facet of the block, what lies beyond it here; `facets`: by tet of the block and
  // corner, which facet of the block is opposite, or -1.
  std::vector<FacetRef> outer(block.facets.size(), FacetRef::none());
  std::vector<std::array<std::int32_t, 4>> facets(block.tets.size(), {-1, -1, -1, -1});
  for (std::size_t w = 0; w < block.facets.size(); ++w)
    facets[block.facets[w].outer.tet()][block.facets[w].outer.corner()] =
        static_cast<std::int32_t>(w);
  for (const Fill& f : *fill)
    for (int i = 0; i < 4; ++i)
      if (f.facet[i] >= 0) outer[f.facet[i]] = slots_[f.tet].n[i];

  const auto moved = [&](const Slot& s, int i) { return names[s.v[i] - kSuper] + kSuper; };
  Polling poll(run);
  for (std::size_t k = 0; k < block.tets.size(); ++k) {
    poll();
    const Slot& s = from.slots_[block.tets[k]];
    const std::array<const Vec3*, 4> p{&points_[moved(s, 0)], &points_[moved(s, 1)],
                                       &points_[moved(s, 2)], &points_[moved(s, 3)]};
    if (kernel::orientation(*p[0], *p[1], *p[2], *p[3]) <= 0) return false;
    for (int i = 0; i < 4; ++i) {
      const FacetRef across = s.n[i];
      std::int32_t vertex = -1;
      if (facets[k][i] >= 0) {
        if (!outer[facets[k][i]].is_tet()) return false;
        vertex = apex(outer[facets[k][i]]);
      } else if (block.number[across.tet()] > static_cast<std::int32_t>(k)) {
        vertex = moved(from.slots_[across.tet()], across.corner());
      } else {
        continue;
      }
      if (kernel::in_sphere(*p[0], *p[1], *p[2], *p[3], points_[vertex]) > 0) return false;
    }
  }

  for (const Fill& f : *fill) release(f.tet);
  std::vector<std::int32_t> place(block.tets.size());
  for (std::int32_t& t : place) t = allocate();
  for (std::size_t k = 0; k < place.size(); ++k) {
    const Slot& s = from.slots_[block.tets[k]];
    for (int i = 0; i < 4; ++i) {
      slots_[place[k]].v[i] = moved(s, i);
      if (facets[k][i] < 0)
        slots_[place[k]].n[i] = {place[block.number[s.n[i].tet()]], s.n[i].corner()};
      else
        join({place[k], i}, outer[facets[k][i]]);
    }
  }
  hint_ = place.front();
  return true;
}

}  // namespace remeshd
