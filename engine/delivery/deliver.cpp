#include "engine/delivery/deliver.h"

#include <algorithm>
#include <iterator>

#include "engine/base/parallel.h"
#include "engine/cellular/boundary_model/sharp_places.h"
#include "engine/delivery/group_areas.h"
#include "engine/mesh/quality.h"
#include "engine/mesh/quality_goals.h"
#include "engine/mesh/tet_boxes.h"
#include "engine/patch/node_map.h"
#include "engine/revision/delaunay_state.h"
#include "engine/sizing/size_rules.h"

namespace remeshd {

namespace {

constexpr std::size_t kBlockPages = 16;
constexpr double kPoor = 0.4;  // volume-length; only tets below may count as across a thin wall

/// A node or tet that has an original keeps its permanent id; the others take the next ones.
CowVector<std::uint64_t> permanent_ids(const CowVector<std::int32_t>& originals,
                                       const CowVector<std::uint64_t>& inherited,
                                       std::uint64_t& next) {
  CowVector<std::uint64_t> ids = inherited;
  ids.resize(originals.size());
  originals.for_each([&](std::size_t k, std::int32_t o) {
    if (o != static_cast<std::int32_t>(k)) ids.edit(k) = o >= 0 ? inherited[o] : next++;
  });
  return ids;
}

/// Tets that were not remade and meet no changed box are in the cells that they were in.
CellsBefore cells_before(const Revision& revision, const Revision& original,
                         std::span<const std::int32_t> remade, const CopyPlan& plan,
                         const Run& run) {
  const PagedMesh& mesh = revision.output.mesh;
  CellsBefore before{&original.output.groups, {}};
  if (remade.size() == mesh.tets.size()) {
    before.others.assign(remade.begin(), remade.end());
    return before;
  }
  const std::vector<std::int32_t> at_change = collect_in_blocks<std::int32_t>(
      mesh.tets.pages(), kBlockPages, run, [&](std::size_t begin, std::size_t end, auto& found) {
        run.poll();
        for (std::size_t page = begin; page < end; ++page) {
          if (!plan.meets_changed(revision.boxes[page])) continue;
          auto k = static_cast<std::int32_t>(page * mesh.tets.kPage);
          for (const Tet& t : mesh.tets.page(page)) {
            if (plan.meets_changed(t, mesh.nodes)) found.push_back(k);
            ++k;
          }
        }
      });
  std::ranges::set_union(remade, at_change, std::back_inserter(before.others));
  return before;
}

/// Measures of the output tets; those of tets that were not remade are the original's.
CowVector<TetMeasure> measures_of(const OutputMesh& d, const Revision& original,
                                  std::span<const std::int32_t> remade, const Run& run) {
  if (remade.size() == d.mesh.tets.size()) return measure_tets(d.mesh.nodes, d.mesh.tets, run);
  std::vector<TetMeasure> anew(remade.size());
  in_blocks(remade.size(), kCheapBlock, run, [&](std::size_t begin, std::size_t end) {
    run.poll();
    for (std::size_t k = begin; k < end; ++k) {
      const Tet& t = d.mesh.tets[remade[k]];
      const auto& p = d.mesh.nodes;
      anew[k] = measure_tet(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
    }
  });
  CowVector<TetMeasure> measures = original.measures;
  measures.resize(d.mesh.tets.size());
  for (std::size_t k = 0; k < remade.size(); ++k) measures.edit(remade[k]) = anew[k];
  return measures;
}

/// Quality of the output mesh, and of the peeled Delaunay mesh: the same but for what clean-up
/// changed.
TwoQualities qualities(const Revision& revision, double volume, const Run& run) {
  const DelaunayState& delaunay_state = *revision.delaunay_state;
  const PagedMesh& delivered = revision.output.mesh;
  double volume_then = volume;
  const CowVector<Vec3>& p = delaunay_state.positions();
  std::vector<std::uint8_t> moved(p.size());
  for (std::size_t k = 0; k < p.pages(); ++k)
    std::ranges::transform(p.page(k), delivered.nodes.page(k), moved.begin() + k * p.kPage,
                           [](const Vec3& a, const Vec3& b) { return a != b ? 1 : 0; });
  std::vector<std::uint8_t> changed(delivered.tets.size(), 0);
  for (const Cavity& cavity : delaunay_state.cavities)
    for (const std::int32_t t : cavity.output) {
      changed[t] = 1;
      volume_then -= tet_volume(delivered.nodes, delivered.tets[t]);
    }
  std::vector<Tet> then;
  delivered.tets.for_each([&](std::size_t t, const Tet& tet) {
    if (!(moved[tet[0]] | moved[tet[1]] | moved[tet[2]] | moved[tet[3]]) || changed[t]) return;
    changed[t] = 1;
    volume_then -= tet_volume(delivered.nodes, tet);
    then.push_back(tet);
  });
  for (const Cavity& cavity : delaunay_state.cavities)
    for (const std::int32_t s : cavity.delaunay) then.push_back(delaunay_state.mesh.corners(s));
  for (const Tet& tet : then) volume_then += tet_volume(p, tet);
  const CowVector<Tet> paged_then(then);
  const CowVector<TetMeasure> measures_then = measure_tets(p, paged_then, run);
  return summarise_both({delivered.nodes, delivered.tets, revision.measures, changed}, volume,
                        {p, paged_then, measures_then}, volume_then);
}

/// Measures `quality_away`: without tets where the model is sharp or across walls thinner than the
/// least size.
void measure_away(Revision& revision) {
  Report& report = revision.report;
  report.quality_away = report.quality;
  report.sharp_tets = 0;
  const SharpPlaces sharp =
      sharp_places(revision.cells.boundary, Membership(revision.model), goals::kLeastDihedral);
  const Sizing& sizing = revision.options.sizing;
  const ThinWalls thin(revision.cells.boundary,
                       sizing.even ? 0 : least_size(sizing, revision.edge_length));
  if (!sharp.any() && sizing.even) return;
  const PagedMesh& mesh = revision.output.mesh;
  const CowVector<Support>& supports = revision.supports();
  std::vector<std::uint8_t> at(mesh.nodes.size());
  for (std::size_t n = 0; n < at.size(); ++n) at[n] = sharp.holds(supports[n]) ? 1 : 0;
  std::vector<std::uint8_t> left_out(mesh.tets.size(), 0);
  double volume = report.quality.volume;
  const auto is_across_film = [&](std::size_t k, const Tet& t) {
    return !sizing.even && revision.measures[k].volume_length < kPoor &&
           thin.holds({supports[t[0]], supports[t[1]], supports[t[2]], supports[t[3]]},
                      {mesh.nodes[t[0]], mesh.nodes[t[1]], mesh.nodes[t[2]], mesh.nodes[t[3]]});
  };
  for (std::size_t k = 0; k < mesh.tets.size(); ++k) {
    const Tet& t = mesh.tets[k];
    if (!(at[t[0]] | at[t[1]] | at[t[2]] | at[t[3]]) && !is_across_film(k, t)) continue;
    left_out[k] = 1;
    ++report.sharp_tets;
    volume -= tet_volume(mesh.nodes, t);
  }
  if (report.sharp_tets > 0)
    report.quality_away = summarise({mesh.nodes, mesh.tets, revision.measures, left_out}, volume);
}

}  // namespace

void account(const Revision& original, std::span<const std::int32_t> remade, double volume,
             Revision& revision, const Run& run) {
  const OutputMesh& d = revision.output;
  Counts& counts = revision.report.counts;
  const auto size = [](const auto& v) { return static_cast<std::uint32_t>(v.size()); };
  counts.nodes = size(d.mesh.nodes);
  counts.tets = size(d.mesh.tets);
  counts.nodes_kept = counts.nodes_moved = counts.tets_kept = 0;
  d.map.node_origin.for_each([&](std::size_t, NodeOrigin origin) {
    counts.nodes_kept += origin == NodeOrigin::Kept ? 1 : 0;
    counts.nodes_moved += origin == NodeOrigin::Moved ? 1 : 0;
  });
  counts.nodes_new = counts.nodes - counts.nodes_kept - counts.nodes_moved;
  d.map.original_tet.for_each(
      [&](std::size_t, std::int32_t t) { counts.tets_kept += t >= 0 ? 1 : 0; });
  revision.measures = measures_of(d, original, remade, run);
  Report& report = revision.report;
  if (revision.delaunay_state != original.delaunay_state) {
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

void deliver_kept(const Revision& original, CowVector<Vec3> nodes,
                  std::span<const std::int32_t> changed_tets, Revision& revision) {
  OutputMesh& d = revision.output;
  d = original.output;
  d.mesh.nodes = std::move(nodes);
  revision.boxes = boxes_round(d.mesh, original.boxes, changed_tets);
  d.map = map_kept(original, d.mesh.nodes);
  revision.delaunay_state = original.delaunay_state;
  revision.report.quality_before = original.report.quality_before;
  revision.report.free_share = 0;
  revision.report.counts.nodes_copied = static_cast<std::uint32_t>(d.mesh.nodes.size());
  revision.report.counts.boundary_facets = static_cast<std::uint32_t>(d.groups.facets.size());
}

void name_output(std::span<const SurfaceFacet> surface, const CowVector<Support>& supports,
                 const Membership& membership, const CellsBefore& before, Revision& revision,
                 const Run& run) {
  OutputMesh& d = revision.output;
  d.groups = name_groups(d.mesh, surface, supports, revision.model, membership,
                         revision.cells.boundary, before, run);
  revision.report.counts.boundary_facets = static_cast<std::uint32_t>(d.groups.facets.size());
  revision.report.groups =
      group_areas(d.mesh, d.groups, revision.model, membership, revision.cells);
}

void deliver(Candidate c, const Revision& original, const Revision& parent, const CopyPlan& plan,
             Revision& revision, const Run& run) {
  revision.report.verification = figures_of(c.verification);
  OutputMesh& d = revision.output;
  d.map = std::move(c.whole.map);
  DelaunayState& state = c.whole.delaunay_state;
  state.next_node_id = parent.delaunay_state->next_node_id;
  state.next_tet_id = parent.delaunay_state->next_tet_id;
  d.node_ids = permanent_ids(d.map.original_node, original.output.node_ids, state.next_node_id);
  d.tet_ids = permanent_ids(d.map.original_tet, original.output.tet_ids, state.next_tet_id);
  d.mesh = std::move(c.whole.mesh);
  revision.delaunay_state = std::make_shared<const DelaunayState>(std::move(state));
  const double volume = c.verification.volume;
  const std::vector<std::int32_t> remade = std::move(c.verification.changed_tets);
  revision.boxes = boxes_round(d.mesh, original.boxes, remade);
  const auto name = [&] {
    name_output(c.verification.surface, revision.delaunay_state->supports, plan.modified(),
                cells_before(revision, original, remade, plan, run), revision, run);
  };
  const auto measure = [&] { account(original, remade, volume, revision, run); };
  side_by_side({name, measure}, run);
}

}  // namespace remeshd
