#include "engine/remesh/deliver.h"

#include <algorithm>
#include <iterator>
#include <numbers>

#include "engine/base/parallel.h"
#include "engine/cellular/sharp_places.h"
#include "engine/remesh/group_areas.h"
#include "engine/remesh/groups.h"
#include "engine/remesh/master.h"
#include "engine/remesh/node_map.h"

namespace remeshd {

namespace {

constexpr double kSharp = 25 * std::numbers::pi / 180;
constexpr std::size_t kBlock = 4096;

/// A node or tet that has an original keeps its permanent id; the others take the next ones.
Pages<std::uint64_t> permanent_ids(const Pages<std::int32_t>& originals,
                                   const Pages<std::uint64_t>& inherited, std::uint64_t& next) {
  Pages<std::uint64_t> ids = inherited;
  ids.resize(originals.size());
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (const std::int32_t o = originals[k]; o != static_cast<std::int32_t>(k))
      ids.edit(k) = o >= 0 ? inherited[o] : next++;
  return ids;
}

/// One bit for each side of the box that a node is beyond, by node: where all nodes of a tet have
/// one in common, the tet misses the box.
std::vector<std::uint8_t> sides_of(const Box& box, const Pages<Vec3>& nodes) {
  std::vector<std::uint8_t> sides(nodes.size());
  for (std::size_t n = 0; n < sides.size(); ++n) {
    const Vec3& p = nodes[n];
    const int beyond = (p.x < box.lo.x ? 1 : 0) | (p.x > box.hi.x ? 2 : 0) |
                       (p.y < box.lo.y ? 4 : 0) | (p.y > box.hi.y ? 8 : 0) |
                       (p.z < box.lo.z ? 16 : 0) | (p.z > box.hi.z ? 32 : 0);
    sides[n] = static_cast<std::uint8_t>(beyond);
  }
  return sides;
}

/// Tets that were not remade and meet no changed box are in the cells that they were in.
CellsBefore cells_before(const Delivery& d, const Revision* original,
                         std::span<const std::int32_t> remade, const PointSource& source,
                         const Run& run) {
  if (!original) return {};
  Box changed;
  for (const Box& box : source.changed()) {
    changed.add(box.lo);
    changed.add(box.hi);
  }
  const std::vector<std::uint8_t> sides = sides_of(changed, d.mesh.nodes);
  const std::vector<std::int32_t> at_change = collect_in_blocks<std::int32_t>(
      d.mesh.tets.size(), kBlock, run, [&](std::size_t begin, std::size_t end, auto& found) {
        run.poll();
        for (std::size_t k = begin; k < end; ++k) {
          const Tet& t = d.mesh.tets[k];
          if ((sides[t[0]] & sides[t[1]] & sides[t[2]] & sides[t[3]]) == 0 &&
              source.meets_changed(t, d.mesh.nodes))
            found.push_back(static_cast<std::int32_t>(k));
        }
      });
  CellsBefore before{&original->delivery.groups, {}};
  std::ranges::set_union(remade, at_change, std::back_inserter(before.others));
  return before;
}

/// Measures of the delivered tets; those of tets that were not remade are the original's.
Pages<TetMeasure> measures_of(const Delivery& d, const Revision* original,
                              std::span<const std::int32_t> remade, const Run& run) {
  if (!original) return measure_tets(d.mesh.nodes, d.mesh.tets, run);
  std::vector<TetMeasure> anew(remade.size());
  in_blocks(remade.size(), kBlock, run, [&](std::size_t begin, std::size_t end) {
    run.poll();
    for (std::size_t k = begin; k < end; ++k) {
      const Tet& t = d.mesh.tets[remade[k]];
      const auto& p = d.mesh.nodes;
      anew[k] = measure_tet(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
    }
  });
  Pages<TetMeasure> measures = original->measures;
  measures.resize(d.mesh.tets.size());
  for (std::size_t k = 0; k < remade.size(); ++k) measures.edit(remade[k]) = anew[k];
  return measures;
}

double volume_of(const Pages<Vec3>& p, const Tet& t) {
  return tet_volume(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
}

/// Quality of the peeled Delaunay mesh: that of the delivered one but for what clean-up changed.
Quality quality_before(const Master& master, const PagedMesh& delivered,
                       const Pages<TetMeasure>& measures, double volume, const Run& run) {
  const Pages<Vec3>& p = master.positions();
  std::vector<std::uint8_t> moved(p.size());
  for (std::size_t n = 0; n < moved.size(); ++n) moved[n] = p[n] != delivered.nodes[n] ? 1 : 0;
  std::vector<std::uint8_t> changed(delivered.tets.size(), 0);
  for (const Cluster& cluster : master.clusters)
    for (const std::int32_t t : cluster.delivered) {
      changed[t] = 1;
      volume -= volume_of(delivered.nodes, delivered.tets[t]);
    }
  std::vector<Tet> then;
  for (std::size_t t = 0; t < changed.size(); ++t) {
    const Tet& tet = delivered.tets[t];
    if (changed[t] || !(moved[tet[0]] | moved[tet[1]] | moved[tet[2]] | moved[tet[3]])) continue;
    changed[t] = 1;
    volume -= volume_of(delivered.nodes, tet);
    then.push_back(tet);
  }
  for (const Cluster& cluster : master.clusters)
    for (const std::int32_t s : cluster.delaunay) then.push_back(master.mesh.corners(s));
  for (const Tet& tet : then) volume += volume_of(p, tet);
  const Pages<Tet> paged_then(then);
  const Pages<TetMeasure> measures_then = measure_tets(p, paged_then, run);
  return summarise(
      {{delivered.nodes, delivered.tets, measures, changed}, {p, paged_then, measures_then}},
      volume);
}

/// Quality away from where the model is sharp.
void measure_away(Revision& revision) {
  Report& report = revision.report;
  report.quality_away = report.quality;
  report.sharp_tets = 0;
  const SharpPlaces sharp =
      sharp_places(revision.cells.boundary, Membership(revision.model), kSharp);
  if (!sharp.any()) return;
  const PagedMesh& mesh = revision.delivery.mesh;
  const Pages<Support>& supports = revision.supports();
  std::vector<std::uint8_t> at(mesh.nodes.size());
  for (std::size_t n = 0; n < at.size(); ++n) at[n] = sharp.holds(supports[n]) ? 1 : 0;
  std::vector<std::uint8_t> left_out(mesh.tets.size(), 0);
  double volume = report.quality.volume;
  for (std::size_t k = 0; k < mesh.tets.size(); ++k) {
    const Tet& t = mesh.tets[k];
    if (!(at[t[0]] | at[t[1]] | at[t[2]] | at[t[3]])) continue;
    left_out[k] = 1;
    ++report.sharp_tets;
    volume -= volume_of(mesh.nodes, t);
  }
  if (report.sharp_tets > 0)
    report.quality_away = summarise({{mesh.nodes, mesh.tets, revision.measures, left_out}}, volume);
}

}  // namespace

std::vector<std::int32_t> remade_tets(const Delivery& d, const Run& run) {
  std::vector<std::uint8_t> in_place;
  for (const Transform& t : d.map.transforms) in_place.push_back(t.is_identity() ? 1 : 0);
  const bool any_moved = std::ranges::count(in_place, 0) > 0;
  const auto& was = d.map.original_tet;
  return collect_in_blocks<std::int32_t>(
      was.size(), kBlock, run, [&](std::size_t begin, std::size_t end, auto& found) {
        run.poll();
        for (std::size_t k = begin; k < end; ++k) {
          const auto tet = static_cast<std::int32_t>(k);
          if (was[k] != tet || (any_moved && !in_place[d.map.node_transform[d.mesh.tets[k][0]]]))
            found.push_back(tet);
        }
      });
}

void account(const Revision* original, std::span<const std::int32_t> remade, double volume,
             Revision& revision, const Run& run) {
  const Delivery& d = revision.delivery;
  Counts& counts = revision.report.counts;
  const auto size = [](const auto& v) { return static_cast<std::uint32_t>(v.size()); };
  counts.nodes = size(d.mesh.nodes);
  counts.tets = size(d.mesh.tets);
  const auto count = [&](NodeOrigin origin) {
    return static_cast<std::uint32_t>(
        std::count(d.map.node_origin.begin(), d.map.node_origin.end(), origin));
  };
  counts.nodes_kept = count(NodeOrigin::Kept);
  counts.nodes_moved = count(NodeOrigin::Moved);
  counts.tets_kept = static_cast<std::uint32_t>(std::count_if(
      d.map.original_tet.begin(), d.map.original_tet.end(), [](std::int32_t t) { return t >= 0; }));
  revision.measures = measures_of(d, original, remade, run);
  revision.report.quality = summarise({{d.mesh.nodes, d.mesh.tets, revision.measures}}, volume);
  measure_away(revision);
  revision.report.volume = volume;
  revision.report.exact_volume = revision.cells.volume;
}

VerificationFigures figures_of(const Verification& v) {
  return {v.tets_proved, v.tets_inherited, v.chord_error, v.volume_error};
}

void deliver_kept(const Revision& original, Pages<Vec3> nodes, Revision& revision) {
  Delivery& d = revision.delivery;
  d = original.delivery;
  d.mesh.nodes = std::move(nodes);
  d.map = map_kept(original, d.mesh.nodes);
  revision.master = original.master;
  revision.report.quality_before = original.report.quality_before;
  revision.report.free_share = 0;
  revision.report.counts.nodes_copied = static_cast<std::uint32_t>(d.mesh.nodes.size());
  revision.report.counts.boundary_facets = static_cast<std::uint32_t>(d.groups.facets.size());
}

void name_delivery(std::span<const SurfaceFacet> surface, const Pages<Support>& supports,
                   const Membership& membership, const CellsBefore& before, Revision& revision,
                   const Run& run) {
  Delivery& d = revision.delivery;
  d.groups = name_groups(d.mesh, surface, supports, revision.model, membership,
                         revision.cells.boundary, before, run);
  revision.report.counts.boundary_facets = static_cast<std::uint32_t>(d.groups.facets.size());
  revision.report.groups =
      group_areas(d.mesh, d.groups, revision.model, membership, revision.cells);
}

void deliver(Candidate c, const Revision* original, const Revision* parent,
             const PointSource& source, Revision& revision, const Run& run) {
  revision.report.verification = figures_of(c.verification);
  Delivery& d = revision.delivery;
  d.map = std::move(c.whole.map);
  Master& master = c.whole.master;
  if (parent) {
    master.next_node_id = parent->master->next_node_id;
    master.next_tet_id = parent->master->next_tet_id;
  }
  const Delivery nothing;
  const Delivery& before = original ? original->delivery : nothing;
  d.node_ids = permanent_ids(d.map.original_node, before.node_ids, master.next_node_id);
  d.tet_ids = permanent_ids(d.map.original_tet, before.tet_ids, master.next_tet_id);
  d.mesh = std::move(c.whole.mesh);
  revision.master = std::make_shared<const Master>(std::move(master));
  const double volume = c.verification.volume;
  std::vector<std::int32_t> remade;
  if (original) remade = remade_tets(d, run);
  const auto name = [&] {
    name_delivery(c.verification.surface, revision.master->supports, source.modified(),
                  cells_before(d, original, remade, source, run), revision, run);
  };
  const auto measure = [&] {
    account(original, remade, volume, revision, run);
    revision.report.quality_before =
        quality_before(*revision.master, d.mesh, revision.measures, volume, run);
  };
  side_by_side({name, measure}, run);
}

}  // namespace remeshd
