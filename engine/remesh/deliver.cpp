#include "engine/remesh/deliver.h"

#include <algorithm>
#include <numbers>

#include "engine/cellular/sharp_places.h"
#include "engine/remesh/group_areas.h"
#include "engine/remesh/groups.h"
#include "engine/remesh/master.h"
#include "engine/remesh/node_map.h"

namespace remeshd {

namespace {

constexpr double kSharp = 25 * std::numbers::pi / 180;

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

VerificationFigures figures_of(const Verification& v) {
  return {v.tets_proved, v.tets_inherited, v.chord_error, v.volume_error};
}

void deliver_kept(const Revision& original, std::vector<Vec3> nodes, Revision& revision) {
  Delivery& d = revision.delivery;
  d = original.delivery;
  d.mesh.nodes = std::move(nodes);
  d.map = map_kept(original, d.mesh.nodes);
  revision.master = original.master;
  revision.report.quality_before = original.report.quality_before;
  revision.report.free_share = 0;
  revision.report.counts.nodes_copied = static_cast<std::uint32_t>(d.mesh.nodes.size());
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
  revision.report.quality_before = measure_quality(c.nodes.positions, c.delaunay, run);
  revision.report.verification = figures_of(c.verification);
  Delivery& d = revision.delivery;
  d.map = std::move(c.map);
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
