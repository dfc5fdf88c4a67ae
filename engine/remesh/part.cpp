#include "engine/remesh/part.h"

#include <algorithm>
#include <cmath>

namespace remeshd {

namespace {

/// The tets at inner nodes, those of clusters that one of them is in, and tets outside of the model
/// that changing nodes may lie in the balls of: these may reach far.
std::vector<std::int32_t> slots_at(const Master& master, const std::vector<std::uint8_t>& inner,
                                   const Surroundings* changing) {
  const auto count = static_cast<std::int32_t>(master.mesh.slots());
  std::vector<std::uint8_t> taken(count, 0);
  std::vector<std::uint8_t> clusters(master.clusters.size(), 0);
  const auto near = [&](const Box& box) { return !changing || changing->may_hold_some_of(box); };
  master.mesh.for_each_slot_near(near, [&](std::int32_t s) {
    const bool wanted = std::ranges::any_of(
        master.mesh.corners(s), [&](std::int32_t n) { return n >= 0 && inner[n] != 0; });
    if (!wanted) return;
    taken[s] = 1;
    if (const std::int32_t c = master.cluster_of(s); c >= 0) clusters[c] = 1;
  });
  const auto may_be_entered = [&](std::int32_t s) {
    const kernel::PagedDelaunay::Ball ball = master.mesh.ball(s);
    return changing->meets(ball.centre, ball.radius);
  };
  if (changing)
    master.tet_of_slot.for_each([&](std::size_t s, std::int32_t tet) {
      const auto slot = static_cast<std::int32_t>(s);
      if (tet == Master::kOutside && taken[s] == 0 && master.mesh.in_use(slot) &&
          may_be_entered(slot))
        taken[s] = 1;
    });
  for (std::size_t c = 0; c < clusters.size(); ++c)
    if (clusters[c] != 0)
      for (const std::int32_t s : master.clusters[c].delaunay) taken[s] = 1;
  std::vector<std::int32_t> slots;
  for (std::int32_t s = 0; s < count; ++s)
    if (taken[s] != 0) slots.push_back(s);
  return slots;
}

}  // namespace

OriginalPart cut_out(const Master& master, const PagedMesh& delivered,
                     const std::vector<std::uint8_t>& inner, const Surroundings* changing) {
  OriginalPart part;
  const std::vector<std::int32_t> slots = slots_at(master, inner, changing);

  // The delivered tets of all pieces, and which slots have them.
  std::vector<std::int32_t> delivered_number(slots.size(), -1);
  std::vector<std::int32_t> cluster_number(master.clusters.size(), -1);
  const auto deliver = [&](std::int32_t tet) {
    part.delivered_tet.push_back(tet);
    return static_cast<std::int32_t>(part.delivered_tet.size()) - 1;
  };
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::int32_t s = slots[k];
    if (!master.inside(s)) continue;
    const std::int32_t c = master.cluster_of(s);
    if (c < 0) {
      delivered_number[k] = deliver(master.tet_of_slot[s]);
    } else if (cluster_number[c] < 0) {
      cluster_number[c] = static_cast<std::int32_t>(part.pieces.clusters.size());
      Cluster& cluster = part.pieces.clusters.emplace_back();
      part.clusters.push_back(c);
      for (const std::int32_t t : master.clusters[c].delivered)
        cluster.delivered.push_back(deliver(t));
    }
  }

  std::vector<std::int32_t> name(delivered.nodes.size(), -1);
  for (const std::int32_t s : slots)
    for (const std::int32_t n : master.mesh.corners(s))
      if (n >= 0) name[n] = 0;
  for (const std::int32_t t : part.delivered_tet)
    for (const std::int32_t n : delivered.tets[t]) name[n] = 0;
  for (std::int32_t n = 0; n < static_cast<std::int32_t>(name.size()); ++n) {
    if (name[n] < 0) continue;
    name[n] = static_cast<std::int32_t>(part.nodes.size());
    part.nodes.push_back(n);
    part.inner.push_back(inner[n]);
    part.positions.push_back(master.positions()[n]);
    part.delivered_nodes.push_back(delivered.nodes[n]);
  }
  const auto renamed = [&](Tet t) {
    for (std::int32_t& n : t) n = name[n];
    return t;
  };
  for (const std::int32_t t : part.delivered_tet)
    part.delivered.push_back(renamed(delivered.tets[t]));
  part.mesh = master.mesh.cut(slots, name, static_cast<std::int32_t>(part.nodes.size()), part.cut);
  for (const std::int32_t facet : part.cut.beyond)
    part.beyond.push_back(master.inside(facet >> 2) ? 1 : 0);

  part.inside.assign(slots.size(), 0);
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::int32_t s = slots[k];
    if (!master.inside(s)) continue;
    part.inside[k] = 1;
    const std::int32_t c = master.cluster_of(s);
    part.pieces.same.push_back(delivered_number[k]);
    part.pieces.cluster.push_back(c < 0 ? -1 : cluster_number[c]);
    if (c >= 0)
      part.pieces.clusters[cluster_number[c]].delaunay.push_back(
          static_cast<std::int32_t>(part.tets.size()));
    part.tets.push_back(renamed(master.mesh.corners(s)));
  }
  return part;
}

std::optional<LocalNodes> localise(const NodeSet& near, std::span<const std::int32_t> looked_at,
                                   const Master& master, const Pages<Support>& supports,
                                   const PagedMesh& delivered, const EntityMap* map,
                                   const PointSource& source, double reach) {
  const std::int32_t identity = source.identity();
  const auto stays = [&](std::int32_t n) {
    return !near.free[n] && near.original[n] >= 0 && near.transform[n] == identity;
  };
  LocalNodes local;
  std::vector<std::uint8_t> looked(delivered.nodes.size(), 0);  // 1: gone or changed, 2: stays
  for (const std::int32_t o : looked_at) looked[o] = 1;
  for (std::int32_t n = 0; n < near.size(); ++n)
    if (stays(n)) looked[near.original[n]] = 2;
  std::vector<std::uint8_t> inner(delivered.nodes.size(), 1);
  std::optional<Surroundings> changing;
  if (std::isfinite(reach)) {
    std::vector<Vec3> changed;
    for (std::int32_t n = 0; n < near.size(); ++n)
      if (!stays(n)) changed.push_back(near.positions[n]);
    for (const std::int32_t o : looked_at)
      if (looked[o] == 1) changed.push_back(master.positions()[o]);
    changing.emplace(changed, reach, source.modified().bounds());
    for (std::size_t n = 0; n < inner.size(); ++n)
      inner[n] = changing->holds(master.positions()[n]) ? 1 : 0;
  }
  local.part = cut_out(master, delivered, inner, changing ? &*changing : nullptr);
  const OriginalPart& part = local.part;

  NodeSet& nodes = local.nodes;
  const auto add = [&](std::int32_t original, const Vec3& position, const Support& support,
                       std::uint8_t free, std::int32_t transform) {
    nodes.positions.push_back(position);
    nodes.supports.push_back(support);
    nodes.free.push_back(free);
    nodes.original.push_back(original);
    nodes.transform.push_back(transform);
  };
  const auto add_kept = [&](std::int32_t p) {
    const std::optional<Support> support = (*map)(supports[part.nodes[p]], part.positions[p]);
    if (support) add(p, part.positions[p], *support, 0, identity);
    return support.has_value();
  };
  const auto count = static_cast<std::int32_t>(part.nodes.size());
  std::vector<std::int32_t> in_part(delivered.nodes.size(), -1);
  for (std::int32_t p = 0; p < count; ++p) {
    in_part[part.nodes[p]] = p;
    if (!part.inner[p] && !add_kept(p)) return std::nullopt;
  }
  nodes.rim = nodes.size();
  for (std::int32_t p = 0; p < count; ++p)
    if (part.inner[p] && looked[part.nodes[p]] == 0 && !add_kept(p)) return std::nullopt;
  local.placed = nodes.size();
  for (std::int32_t n = 0; n < near.size(); ++n) {
    const std::int32_t o = near.original[n];
    const std::int32_t p = o < 0 ? -1 : in_part[o];
    if (stays(n) && (p < 0 || !part.inner[p])) continue;
    add(p, near.positions[n], near.supports[n], near.free[n], near.transform[n]);
  }
  nodes.elsewhere = static_cast<std::int32_t>(delivered.nodes.size()) - count;
  return local;
}

}  // namespace remeshd
