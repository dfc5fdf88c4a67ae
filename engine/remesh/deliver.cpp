#include "engine/remesh/deliver.h"

#include <algorithm>
#include <numbers>

#include "engine/cellular/sharp_places.h"
#include "engine/remesh/group_areas.h"
#include "engine/remesh/groups.h"
#include "engine/remesh/master.h"
#include "engine/remesh/tet_index.h"

namespace remeshd {

namespace {

constexpr double kSharp = 25 * std::numbers::pi / 180;

/// Puts the nodes that the clean-up has made superfluous behind all others, so that those of the
/// delivered mesh come first in the master too. Returns how many are delivered.
std::size_t order_nodes(Candidate& c) {
  std::vector<std::int32_t> number(c.nodes.positions.size(), -1);
  for (const Tet& t : c.mesh.tets)
    for (const std::int32_t n : t) number[n] = 0;
  const std::size_t used = number.size() - std::count(number.begin(), number.end(), -1);
  if (used == number.size()) return used;
  std::int32_t front = 0;
  auto back = static_cast<std::int32_t>(used);
  for (std::int32_t& n : number) n = n < 0 ? back++ : front++;
  const NodeSet old = c.nodes;
  const std::vector<Vec3> placed = c.mesh.nodes;
  for (std::size_t k = 0; k < number.size(); ++k) {
    const std::int32_t n = number[k];
    c.nodes.positions[n] = old.positions[k];
    c.nodes.supports[n] = old.supports[k];
    c.nodes.free[n] = old.free[k];
    c.nodes.original[n] = old.original[k];
    c.nodes.transform[n] = old.transform[k];
    c.mesh.nodes[n] = placed[k];
  }
  c.mesh.nodes.resize(used);
  for (auto* tets : {&c.mesh.tets, &c.delaunay})
    for (Tet& t : *tets)
      for (std::int32_t& n : t) n = number[n];
  for (SurfaceFacet& f : c.verification.surface)
    for (std::int32_t& n : f.nodes) n = number[n];
  c.loop.mesh.rename(number, c.nodes.size());
  return used;
}

NodeMap map_nodes(const Candidate& c, const Revision* original, const PointSource& source,
                  const Run& run) {
  NodeMap map;
  const std::size_t count = c.mesh.nodes.size();
  map.node_origin.assign(count, NodeOrigin::New);
  map.original_node.assign(count, -1);
  map.node_transform.assign(count, -1);
  map.original_tet.assign(c.mesh.tets.size(), -1);
  if (!original) return map;
  map.transforms = source.transforms();
  map.transform_features.resize(map.transforms.size());
  for (const SourceFeature& s : source.sources())
    if (map.transform_features[s.transform].empty())
      map.transform_features[s.transform] = original->model.features[s.original].id;
  const TetMesh& then = original->delivery.mesh;
  for (std::size_t n = 0; n < count; ++n) {
    const std::int32_t o = c.nodes.original[n];
    if (o < 0 || static_cast<std::size_t>(o) >= then.nodes.size()) continue;
    const Vec3 copied = source.transforms()[c.nodes.transform[n]].apply(then.nodes[o]);
    map.node_origin[n] = c.mesh.nodes[n] == copied ? NodeOrigin::Kept : NodeOrigin::Moved;
    map.original_node[n] = o;
    map.node_transform[n] = c.nodes.transform[n];
  }
  Polling poll(run);
  const TetIndex index(then.tets, then.nodes.size(), poll);
  for (std::size_t k = 0; k < c.mesh.tets.size(); ++k) {
    poll();
    const Tet& t = c.mesh.tets[k];
    const bool kept = std::all_of(t.begin(), t.end(), [&](std::int32_t n) {
      return map.node_origin[n] == NodeOrigin::Kept &&
             map.node_transform[n] == map.node_transform[t[0]];
    });
    if (kept)
      map.original_tet[k] = index.find({map.original_node[t[0]], map.original_node[t[1]],
                                        map.original_node[t[2]], map.original_node[t[3]]});
  }
  return map;
}

/// A node or tet that has an original keeps its permanent id; the others take the next ones.
std::vector<std::uint64_t> permanent_ids(std::span<const std::int32_t> originals,
                                         const std::vector<std::uint64_t>* inherited,
                                         std::uint64_t& next) {
  std::vector<std::uint64_t> ids;
  ids.reserve(originals.size());
  for (const std::int32_t o : originals) ids.push_back(o >= 0 ? (*inherited)[o] : next++);
  return ids;
}

/// Quality away from where the model is sharp.
void measure_away(Revision& revision, const Run& run) {
  Report& report = revision.report;
  report.quality_away = report.quality;
  report.sharp_tets = 0;
  const SharpPlaces sharp =
      sharp_places(revision.cells.boundary, Membership(revision.model), kSharp);
  if (!sharp.any()) return;
  const TetMesh& mesh = revision.delivery.mesh;
  const std::span<const Support> supports = revision.supports();
  std::vector<std::uint8_t> at(mesh.nodes.size());
  for (std::size_t n = 0; n < at.size(); ++n) at[n] = sharp.holds(supports[n]) ? 1 : 0;
  std::vector<Tet> away;
  away.reserve(mesh.tets.size());
  for (const Tet& t : mesh.tets)
    if (!(at[t[0]] || at[t[1]] || at[t[2]] || at[t[3]])) away.push_back(t);
  report.sharp_tets = static_cast<std::uint32_t>(mesh.tets.size() - away.size());
  if (report.sharp_tets > 0) report.quality_away = measure_quality(mesh.nodes, away, run);
}

}  // namespace

void account(Revision& revision, const Run& run) {
  const Delivery& d = revision.delivery;
  Counts& counts = revision.report.counts;
  const auto size = [](const auto& v) { return static_cast<std::uint32_t>(v.size()); };
  counts.nodes = size(d.mesh.nodes);
  counts.tets = size(d.mesh.tets);
  counts.boundary_facets = size(d.groups.facets);
  const auto count = [&](NodeOrigin origin) {
    return static_cast<std::uint32_t>(
        std::count(d.map.node_origin.begin(), d.map.node_origin.end(), origin));
  };
  counts.nodes_kept = count(NodeOrigin::Kept);
  counts.nodes_moved = count(NodeOrigin::Moved);
  counts.tets_kept = static_cast<std::uint32_t>(std::count_if(
      d.map.original_tet.begin(), d.map.original_tet.end(), [](std::int32_t t) { return t >= 0; }));
  revision.report.quality = measure_quality(d.mesh.nodes, d.mesh.tets, run);
  measure_away(revision, run);
  revision.report.volume = revision.report.quality.volume;
  revision.report.exact_volume = revision.cells.volume;
}

void deliver_kept(const Revision& original, std::vector<Vec3> nodes, Revision& revision) {
  Delivery& d = revision.delivery;
  d = original.delivery;
  d.mesh.nodes = std::move(nodes);
  const std::vector<Vec3>& then = original.delivery.mesh.nodes;
  NodeMap& map = d.map;
  map = {};
  map.transforms = {Transform{}};
  map.transform_features = {original.model.features.front().id};
  map.node_transform.assign(then.size(), 0);
  for (std::size_t n = 0; n < then.size(); ++n) {
    map.node_origin.push_back(d.mesh.nodes[n] == then[n] ? NodeOrigin::Kept : NodeOrigin::Moved);
    map.original_node.push_back(static_cast<std::int32_t>(n));
  }
  for (std::size_t t = 0; t < d.mesh.tets.size(); ++t) {
    const Tet& tet = d.mesh.tets[t];
    const bool kept = std::all_of(tet.begin(), tet.end(), [&](std::int32_t n) {
      return map.node_origin[n] == NodeOrigin::Kept;
    });
    map.original_tet.push_back(kept ? static_cast<std::int32_t>(t) : -1);
  }
  revision.master = original.master;
  revision.report.quality_before = original.report.quality_before;
  revision.report.free_share = 0;
  revision.report.counts.nodes_copied = static_cast<std::uint32_t>(then.size());
}

void name_delivery(std::span<const SurfaceFacet> surface, std::span<const Support> supports,
                   const Membership& membership, Revision& revision, const Run& run) {
  Delivery& d = revision.delivery;
  d.groups = name_groups(d.mesh, surface, supports, revision.model, membership,
                         revision.cells.boundary, run);
  revision.report.groups =
      group_areas(d.mesh, d.groups, revision.model, membership, revision.cells);
}

void deliver(Candidate c, const Revision* original, const Revision* parent,
             const PointSource& source, Revision& revision, const Run& run) {
  order_nodes(c);
  revision.report.quality_before = measure_quality(c.nodes.positions, c.delaunay, run);
  Delivery& d = revision.delivery;
  d.map = map_nodes(c, original, source, run);
  Master master;
  if (parent) {
    master.next_node_id = parent->master->next_node_id;
    master.next_tet_id = parent->master->next_tet_id;
  }
  d.node_ids = permanent_ids(d.map.original_node, original ? &original->delivery.node_ids : nullptr,
                             master.next_node_id);
  d.tet_ids = permanent_ids(d.map.original_tet, original ? &original->delivery.tet_ids : nullptr,
                            master.next_tet_id);
  d.mesh = std::move(c.mesh);
  name_delivery(c.verification.surface, c.nodes.supports, source.modified(), revision, run);
  master.positions = std::move(c.nodes.positions);
  master.supports = std::move(c.nodes.supports);
  master.mesh = std::move(c.loop.mesh);
  master.tets = std::move(c.delaunay);
  revision.master = std::make_shared<const Master>(std::move(master));
  account(revision, run);
}

}  // namespace remeshd
