#include "engine/remesh/deliver.h"

#include <algorithm>
#include <iterator>
#include <numbers>

#include "engine/base/parallel.h"
#include "engine/cellular/sharp_places.h"
#include "engine/mesh/quality.h"
#include "engine/mesh/tet_boxes.h"
#include "engine/remesh/group_areas.h"
#include "engine/remesh/groups.h"
#include "engine/remesh/master.h"
#include "engine/remesh/node_map.h"

namespace remeshd {

namespace {

constexpr double kSharp = 25 * std::numbers::pi / 180;
constexpr std::size_t kBlock = 4096;
constexpr std::size_t kBlockPages = 16;

/// A node or tet that has an original keeps its permanent id; the others take the next ones.
Pages<std::uint64_t> permanent_ids(const Pages<std::int32_t>& originals,
                                   const Pages<std::uint64_t>& inherited, std::uint64_t& next) {
  Pages<std::uint64_t> ids = inherited;
  ids.resize(originals.size());
  originals.for_each([&](std::size_t k, std::int32_t o) {
    if (o != static_cast<std::int32_t>(k)) ids.edit(k) = o >= 0 ? inherited[o] : next++;
  });
  return ids;
}

/// Tets that were not remade and meet no changed box are in the cells that they were in.
CellsBefore cells_before(const Revision& revision, const Revision* original,
                         std::span<const std::int32_t> remade, const PointSource& source,
                         const Run& run) {
  if (!original) return {};
  const PagedMesh& mesh = revision.delivery.mesh;
  const std::vector<std::int32_t> at_change = collect_in_blocks<std::int32_t>(
      mesh.tets.pages(), kBlockPages, run, [&](std::size_t begin, std::size_t end, auto& found) {
        run.poll();
        for (std::size_t page = begin; page < end; ++page) {
          if (!source.meets_changed(revision.boxes[page])) continue;
          auto k = static_cast<std::int32_t>(page * mesh.tets.kPage);
          for (const Tet& t : mesh.tets.page(page)) {
            if (source.meets_changed(t, mesh.nodes)) found.push_back(k);
            ++k;
          }
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

/// Quality of the delivered mesh, and of the peeled Delaunay mesh: the same but for what clean-up
/// changed.
TwoQualities qualities(const Revision& revision, double volume, const Run& run) {
  const Master& master = *revision.master;
  const PagedMesh& delivered = revision.delivery.mesh;
  double volume_then = volume;
  const Pages<Vec3>& p = master.positions();
  std::vector<std::uint8_t> moved(p.size());
  for (std::size_t k = 0; k < p.pages(); ++k)
    std::ranges::transform(p.page(k), delivered.nodes.page(k), moved.begin() + k * p.kPage,
                           [](const Vec3& a, const Vec3& b) { return a != b ? 1 : 0; });
  std::vector<std::uint8_t> changed(delivered.tets.size(), 0);
  for (const Cluster& cluster : master.clusters)
    for (const std::int32_t t : cluster.delivered) {
      changed[t] = 1;
      volume_then -= volume_of(delivered.nodes, delivered.tets[t]);
    }
  std::vector<Tet> then;
  delivered.tets.for_each([&](std::size_t t, const Tet& tet) {
    if (!(moved[tet[0]] | moved[tet[1]] | moved[tet[2]] | moved[tet[3]]) || changed[t]) return;
    changed[t] = 1;
    volume_then -= volume_of(delivered.nodes, tet);
    then.push_back(tet);
  });
  for (const Cluster& cluster : master.clusters)
    for (const std::int32_t s : cluster.delaunay) then.push_back(master.mesh.corners(s));
  for (const Tet& tet : then) volume_then += volume_of(p, tet);
  const Pages<Tet> paged_then(then);
  const Pages<TetMeasure> measures_then = measure_tets(p, paged_then, run);
  return summarise_both({delivered.nodes, delivered.tets, revision.measures, changed}, volume,
                        {p, paged_then, measures_then}, volume_then);
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
    report.quality_away = summarise({mesh.nodes, mesh.tets, revision.measures, left_out}, volume);
}

}  // namespace

void account(const Revision* original, std::span<const std::int32_t> remade, double volume,
             Revision& revision, const Run& run) {
  const Delivery& d = revision.delivery;
  Counts& counts = revision.report.counts;
  const auto size = [](const auto& v) { return static_cast<std::uint32_t>(v.size()); };
  counts.nodes = size(d.mesh.nodes);
  counts.tets = size(d.mesh.tets);
  counts.nodes_kept = counts.nodes_moved = counts.tets_kept = 0;
  d.map.node_origin.for_each([&](std::size_t, NodeOrigin origin) {
    counts.nodes_kept += origin == NodeOrigin::Kept ? 1 : 0;
    counts.nodes_moved += origin == NodeOrigin::Moved ? 1 : 0;
  });
  d.map.original_tet.for_each(
      [&](std::size_t, std::int32_t t) { counts.tets_kept += t >= 0 ? 1 : 0; });
  revision.measures = measures_of(d, original, remade, run);
  Report& report = revision.report;
  if (!original || revision.master != original->master) {
    const TwoQualities both = qualities(revision, volume, run);
    report.quality = both.first;
    report.quality_before = both.second;
  } else {
    report.quality = summarise({d.mesh.nodes, d.mesh.tets, revision.measures}, volume);
  }
  measure_away(revision);
  report.volume = volume;
  report.exact_volume = revision.cells.volume;
}

VerificationFigures figures_of(const Verification& v) {
  return {v.tets_proved, v.tets_inherited, v.chord_error, v.volume_error};
}

void deliver_kept(const Revision& original, Pages<Vec3> nodes,
                  std::span<const std::int32_t> changed_tets, Revision& revision) {
  Delivery& d = revision.delivery;
  d = original.delivery;
  d.mesh.nodes = std::move(nodes);
  revision.boxes = boxes_round(d.mesh, original.boxes, changed_tets);
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
  const std::vector<std::int32_t> remade = std::move(c.verification.changed_tets);
  revision.boxes = original ? boxes_round(d.mesh, original->boxes, remade) : boxes_round(d.mesh);
  const auto name = [&] {
    name_delivery(c.verification.surface, revision.master->supports, source.modified(),
                  cells_before(revision, original, remade, source, run), revision, run);
  };
  const auto measure = [&] { account(original, remade, volume, revision, run); };
  side_by_side({name, measure}, run);
}

}  // namespace remeshd
