#include "server/service/encode_report.h"

#include "engine/revision/report.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

v1::Report::Way encode(MeshStrategy strategy) {
  switch (strategy) {
    case MeshStrategy::Unchanged:
      return v1::Report::WAY_UNCHANGED;
    case MeshStrategy::Morphed:
      return v1::Report::WAY_MORPHED;
    case MeshStrategy::Local:
      return v1::Report::WAY_LOCAL;
    case MeshStrategy::Full:
      return v1::Report::WAY_FULL;
    case MeshStrategy::Fresh:
      return v1::Report::WAY_FRESH;
    case MeshStrategy::TetGen:
      return v1::Report::WAY_TETGEN;
    case MeshStrategy::Renewed:
      return v1::Report::WAY_RENEWED;
  }
  return v1::Report::WAY_UNSPECIFIED;
}

template <typename Repeated>
void put_point(const Vec3& p, Repeated& out) {
  for (const double c : {p.x, p.y, p.z}) out.Add(c);
}

void put_quality(const Quality& quality, v1::Quality& out) {
  out.set_volume_length_mean(quality.volume_length_mean);
  out.set_volume_length_p01(quality.volume_length_p01);
  out.set_volume_length_min(quality.volume_length_min);
  out.set_dihedral_min(quality.dihedral_min);
  out.set_dihedral_max(quality.dihedral_max);
  out.mutable_histogram()->Assign(quality.histogram.begin(), quality.histogram.end());
}

void put_seconds(const PhaseSeconds& seconds, v1::Report::Seconds& out) {
  out.set_setup(seconds.setup);
  out.set_difference(seconds.difference);
  out.set_copy(seconds.copy);
  out.set_optimise(seconds.optimise);
  out.set_extract(seconds.extract);
  out.set_verify(seconds.verify);
  out.set_total(seconds.total);
}

void put_attempt(const TriedStrategy& attempt, v1::Report::Attempt& out) {
  out.set_strategy(attempt.strategy);
  out.set_reason(attempt.reason);
  out.set_seconds(attempt.seconds);
}

void put_counts(const Counts& counts, v1::Report& out) {
  out.set_nodes(counts.nodes);
  out.set_tets(counts.tets);
  out.set_boundary_facets(counts.boundary_facets);
  out.set_nodes_kept(counts.nodes_kept);
  out.set_nodes_moved(counts.nodes_moved);
  out.set_nodes_new(counts.nodes_new);
  out.set_tets_kept(counts.tets_kept);
  out.set_mid_nodes(counts.mid_nodes);
  out.set_straight_edges(counts.straight_edges);
}

void put_verification(const VerificationFigures& figures, v1::Report::Verification& out) {
  out.set_tets_proved(figures.tets_proved);
  out.set_tets_inherited(figures.tets_inherited);
  out.set_chord_error(figures.chord_error);
  out.set_volume_error(figures.volume_error);
}

void put_group(const GroupFigures& figures, v1::GroupAudit& out) {
  out.set_group(figures.group);
  if (figures.exact_area) out.set_exact_area(*figures.exact_area);
  out.set_mesh_area(figures.mesh_area);
  out.set_nodes(figures.nodes);
  out.set_facets(figures.facets);
  out.set_tets(figures.tets);
  out.set_state(static_cast<v1::GroupAudit::State>(figures.state));
  if (figures.facets == 0) return;
  put_point(figures.centroid, *out.mutable_centroid());
  put_point(figures.normal, *out.mutable_normal());
}

/// `first_mesh`: which half of Table 3 the seconds fill.
void put_diagnostics(const Report& report, bool first_mesh, v1::Diagnostics& out) {
  const PhaseSeconds& seconds = report.seconds;
  v1::Diagnostics::Table3& table = *out.mutable_table3();
  if (first_mesh) {
    table.set_t1(seconds.setup);
    table.set_t2(seconds.optimise);
    table.set_t3(seconds.extract);
  } else {
    table.set_t4(seconds.difference);
    table.set_t5(seconds.copy);
    table.set_t6(seconds.setup);
    table.set_t7(seconds.optimise);
    table.set_t8(seconds.extract);
  }
  const Counts& counts = report.counts;
  out.set_iterations(counts.iterations);
  out.set_samples(counts.samples);
  out.set_active_samples(counts.active_samples);
  out.set_nodes_copied(counts.nodes_copied);
  out.set_nodes_inserted(counts.nodes_inserted);
  out.set_free_at_start(counts.free_at_start);
  out.set_free_at_end(counts.free_at_end);
  out.mutable_free_per_iteration()->Assign(counts.free_per_iteration.begin(),
                                           counts.free_per_iteration.end());
  put_quality(report.quality_before, *out.mutable_quality_before());
  out.set_geometry(report.geometry);
  for (const TriedStrategy& attempt : report.geometry_attempts)
    put_attempt(attempt, *out.add_geometry_attempts());
  out.set_geometry_seconds(report.geometry_seconds);
  put_attempt(report.taken, *out.mutable_taken());
}

}  // namespace

v1::Warning encode(const Warning& warning) {
  v1::Warning out;
  out.set_code(static_cast<v1::Warning::Code>(static_cast<int>(warning.code) + 1));
  out.set_message(warning.message);
  out.mutable_features()->Assign(warning.features.begin(), warning.features.end());
  out.mutable_groups()->Assign(warning.groups.begin(), warning.groups.end());
  if (warning.point) put_point(*warning.point, *out.mutable_point());
  out.set_nodes_needed(warning.nodes_needed);
  return out;
}

v1::Report encode_report(const HeldRevision& held) {
  const Report& report = held.revision.report;
  v1::Report out;
  out.set_revision(report.revision);
  out.set_way(encode(report.strategy));
  out.set_last_resort_share(report.last_resort_share);
  put_counts(report.counts, out);
  out.set_order(held.revision.options.order);
  out.set_volume(report.volume);
  out.set_exact_volume(report.exact_volume);
  out.set_edge_length(report.edge_length);
  out.set_free_share(report.free_share);
  put_seconds(report.seconds, *out.mutable_seconds());
  put_quality(report.quality, *out.mutable_quality());
  put_quality(report.quality_away, *out.mutable_quality_away());
  out.set_sharp_tets(report.sharp_tets);
  put_verification(report.verification, *out.mutable_verification());
  for (const TriedStrategy& attempt : report.attempts) put_attempt(attempt, *out.add_attempts());
  for (const GroupFigures& figures : report.figures) put_group(figures, *out.add_groups());
  for (const Warning& warning : report.warnings) *out.add_warnings() = encode(warning);
  put_diagnostics(report, held.record.parent.empty(), *out.mutable_diagnostics());
  return out;
}

}  // namespace remeshd
