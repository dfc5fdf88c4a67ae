#include "engine/patch/patch.h"

#include <algorithm>
#include <cmath>

#include "engine/revision/delaunay_state.h"

namespace remeshd {

namespace {

/// Slots of the tets at inner nodes, of those in cavities with one of these, and of tets outside of
/// the model whose circumballs, which may be large, nodes may enter that move or come; ascending.
std::vector<std::int32_t> slots_at(const DelaunayState& delaunay_state,
                                   const std::vector<std::uint8_t>& inner,
                                   const Surroundings* changing) {
  const auto count = static_cast<std::int32_t>(delaunay_state.mesh.slots());
  std::vector<std::uint8_t> taken(count, 0);
  std::vector<std::uint8_t> cavities(delaunay_state.cavities.size(), 0);
  const auto near = [&](const Box& box) { return !changing || changing->may_hold_some_of(box); };
  delaunay_state.mesh.for_each_slot_near(near, [&](std::int32_t s) {
    const bool wanted = std::ranges::any_of(
        delaunay_state.mesh.corners(s), [&](std::int32_t n) { return n >= 0 && inner[n] != 0; });
    if (!wanted) return;
    taken[s] = 1;
    if (const std::int32_t c = delaunay_state.cavity_of(s); c >= 0) cavities[c] = 1;
  });
  const auto may_be_entered = [&](std::int32_t s) {
    const PagedDelaunay::Ball ball = delaunay_state.mesh.ball(s);
    return changing->meets(ball.centre, ball.radius);
  };
  if (changing)
    delaunay_state.tet_of_slot.for_each([&](std::size_t s, std::int32_t tet) {
      const auto slot = static_cast<std::int32_t>(s);
      if (tet == DelaunayState::kOutside && taken[s] == 0 && delaunay_state.mesh.in_use(slot) &&
          may_be_entered(slot))
        taken[s] = 1;
    });
  for (std::size_t c = 0; c < cavities.size(); ++c)
    if (cavities[c] != 0)
      for (const std::int32_t s : delaunay_state.cavities[c].delaunay) taken[s] = 1;
  std::vector<std::int32_t> slots;
  for (std::int32_t s = 0; s < count; ++s)
    if (taken[s] != 0) slots.push_back(s);
  return slots;
}

/// Takes the nodes of the slots and of the patch's output tets into the patch; returns their
/// numbers there by node of the original, -1 for the others.
std::vector<std::int32_t> take_nodes(const CopiedMesh& original,
                                     const std::vector<std::int32_t>& slots,
                                     const std::vector<std::uint8_t>& inner, MeshPatch& patch) {
  const DelaunayState& delaunay_state = original.delaunay_state;
  const PagedMesh& output = original.output;
  std::vector<std::int32_t> name(output.nodes.size(), -1);
  for (const std::int32_t s : slots)
    for (const std::int32_t n : delaunay_state.mesh.corners(s))
      if (n >= 0) name[n] = 0;
  for (const std::int32_t t : patch.output_tet)
    for (const std::int32_t n : output.tets[t]) name[n] = 0;
  for (std::int32_t n = 0; n < static_cast<std::int32_t>(name.size()); ++n) {
    if (name[n] < 0) continue;
    name[n] = static_cast<std::int32_t>(patch.nodes.size());
    patch.nodes.push_back(n);
    patch.inner.push_back(inner[n]);
    patch.positions.push_back(original.positions[n]);
    patch.output_nodes.push_back(output.nodes[n]);
  }
  patch.followed.assign(patch.nodes.size(), 0);
  for (const std::int32_t n : original.followed)
    if (name[n] >= 0) patch.followed[name[n]] = 1;
  return name;
}

}  // namespace

MeshPatch cut_patch(const CopiedMesh& original, const std::vector<std::uint8_t>& inner,
                    const Surroundings* changing) {
  const DelaunayState& delaunay_state = original.delaunay_state;
  const PagedMesh& output = original.output;
  MeshPatch patch;
  const std::vector<std::int32_t> slots = slots_at(delaunay_state, inner, changing);

  // The patch's output tets: of each cavity, and of each slot whose tet stands for itself.
  std::vector<std::int32_t> output_number(slots.size(), -1);
  std::vector<std::int32_t> cavity_number(delaunay_state.cavities.size(), -1);
  const auto deliver = [&](std::int32_t tet) {
    patch.output_tet.push_back(tet);
    return static_cast<std::int32_t>(patch.output_tet.size()) - 1;
  };
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::int32_t s = slots[k];
    if (!delaunay_state.inside(s)) continue;
    const std::int32_t c = delaunay_state.cavity_of(s);
    if (c < 0) {
      output_number[k] = deliver(delaunay_state.tet_of_slot[s]);
    } else if (cavity_number[c] < 0) {
      cavity_number[c] = static_cast<std::int32_t>(patch.cavities.list.size());
      Cavity& cavity = patch.cavities.list.emplace_back();
      patch.parent_cavities.push_back(c);
      for (const std::int32_t t : delaunay_state.cavities[c].output)
        cavity.output.push_back(deliver(t));
    }
  }

  const std::vector<std::int32_t> name = take_nodes(original, slots, inner, patch);
  for (const std::int32_t t : patch.output_tet)
    patch.output.push_back(renamed(output.tets[t], name));
  patch.mesh = delaunay_state.mesh.cut(slots, name, static_cast<std::int32_t>(patch.nodes.size()),
                                       patch.cut);
  for (const FacetRef facet : patch.cut.exterior)
    patch.exterior.push_back(delaunay_state.inside(facet.tet()) ? 1 : 0);

  patch.inside.assign(slots.size(), 0);
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const std::int32_t s = slots[k];
    if (!delaunay_state.inside(s)) continue;
    patch.inside[k] = 1;
    const std::int32_t c = delaunay_state.cavity_of(s);
    patch.cavities.same.push_back(output_number[k]);
    patch.cavities.of_tet.push_back(c < 0 ? -1 : cavity_number[c]);
    if (c >= 0)
      patch.cavities.list[cavity_number[c]].delaunay.push_back(
          static_cast<std::int32_t>(patch.tets.size()));
    patch.tets.push_back(renamed(delaunay_state.mesh.corners(s), name));
  }
  return patch;
}

std::optional<PatchNodes> extract_patch(const CopiedNodes& near,
                                        std::span<const std::int32_t> candidates,
                                        const CopiedMesh& original, const EntityMap* map,
                                        const CopyPlan& plan, double reach) {
  const std::int32_t identity = plan.identity();
  const std::size_t all = original.positions.size();
  const auto stays = [&](std::int32_t n) {
    return !near.is_free(n) && near.original[n] >= 0 && near.transform[n] == identity;
  };
  PatchNodes local;
  std::vector<std::uint8_t> state(all, 0);  // 1: gone or changed, 2: stays
  for (const std::int32_t o : candidates) state[o] = 1;
  for (std::int32_t n = 0; n < near.size(); ++n)
    if (stays(n)) state[near.original[n]] = 2;
  std::vector<std::uint8_t> inner(all, 1);
  std::optional<Surroundings> changing;
  if (std::isfinite(reach)) {
    std::vector<Vec3> changed;
    for (std::int32_t n = 0; n < near.size(); ++n)
      if (!stays(n)) changed.push_back(near.positions[n]);
    for (const std::int32_t o : candidates)
      if (state[o] == 1) changed.push_back(original.positions[o]);
    for (const std::int32_t o : original.followed) {
      changed.push_back(original.positions[o]);
      changed.push_back(original.delaunay_state.positions()[o]);
    }
    changing.emplace(changed, reach, plan.modified().bounds());
    for (std::size_t n = 0; n < inner.size(); ++n)
      inner[n] = changing->holds(original.positions[n]) ? 1 : 0;
  }
  local.patch = cut_patch(original, inner, changing ? &*changing : nullptr);
  const MeshPatch& patch = local.patch;

  NodeSet& nodes = local.nodes;
  const auto add_kept = [&](std::int32_t p) {
    const std::optional<Support> support =
        (*map)(original.supports[patch.nodes[p]], patch.positions[p]);
    if (support) nodes.add(patch.positions[p], *support, NodeState::Fixed, p, identity);
    return support.has_value();
  };
  const auto count = static_cast<std::int32_t>(patch.nodes.size());
  std::vector<std::int32_t> in_patch(all, -1);
  for (std::int32_t p = 0; p < count; ++p) {
    in_patch[patch.nodes[p]] = p;
    if (!patch.inner[p] && !add_kept(p)) return std::nullopt;
  }
  nodes.interface_nodes = nodes.size();
  for (std::int32_t p = 0; p < count; ++p)
    if (patch.inner[p] && state[patch.nodes[p]] == 0 && !add_kept(p)) return std::nullopt;
  local.placed = nodes.size();
  for (std::int32_t n = 0; n < near.size(); ++n) {
    const std::int32_t o = near.original[n];
    const std::int32_t p = o < 0 ? -1 : in_patch[o];
    if (stays(n) && (p < 0 || !patch.inner[p])) continue;
    nodes.add(near.positions[n], near.supports[n], near.state[n], p, near.transform[n]);
  }
  nodes.elsewhere = static_cast<std::int32_t>(all) - count;
  return local;
}

}  // namespace remeshd
