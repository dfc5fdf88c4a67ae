#include "engine/revision/storage/stored_documents.h"

#include <cereal/archives/portable_binary.hpp>
#include <sstream>

#include "engine/base/error.h"
#include "engine/revision/storage/stored_archive.h"
#include "engine/revision/storage/stored_types.h"

namespace remeshd {

namespace {
/// The format of the documents, raised with every change of what follows: bytes of an unknown one
/// are refused, never misread. Each is named after what it lacks and the next one has, at the end
/// of the bytes: the report's attempts, those for the boundary, and the one taken; the options'
/// sizing; the models' sizes and dense places; the second order; the models' groups; the hold. 8
/// and 9 are formats of whole revisions (older_format.h).
enum Format : std::uint32_t {
  kNoAttempts = 10,
  kNoGeometryAttempts,
  kNoTaken,
  kNoSizing,
  kNoSizes,
  kNoOrder,
  kNoGroups,
  kNoHold,
  kFormat
};

class DocumentsArchive : public StoredArchive<DocumentsArchive> {
 public:
  explicit DocumentsArchive(std::string_view bytes) : StoredArchive(this, bytes) {}
};
}  // namespace
}  // namespace remeshd

/// cereal asks for the matching output archive: enumerators are read as that writes them.
template <>
struct cereal::traits::detail::get_output_from_input<remeshd::DocumentsArchive> {
  using type = cereal::PortableBinaryOutputArchive;
};

namespace remeshd {

/// But for sizes and groups, which came later and are written apart.
void serialize(auto& a, ModelSource& m) { a(m.name, m.unit, m.parameters, m.features); }
/// But for the id and the seconds, which are not the mesh's own, and for what came later and is
/// written apart.
void serialize(auto& a, Report& r) {
  a(r.strategy, r.counts, r.free_share, r.edge_length, r.volume, r.exact_volume, r.quality_before,
    r.quality, r.quality_away, r.sharp_tets, r.verification, r.groups, r.last_resort_share,
    r.warnings);
}
void serialize(auto& a, TriedStrategy& t) { a(t.strategy, t.reason); }
void serialize(auto& a, SizedBall& b) { a(b.centre, b.radius, b.size); }
void serialize(auto& a, SizeControlSource& s) { a(s.id, s.place, s.size); }
void serialize(auto& a, GroupPolicy& p) { a(p.max_area_change, p.fail_emptied); }
void serialize(auto& a, GroupSource& g) { a(g.name, g.on, g.policy); }
void serialize(auto& a, GroupFigures& f) {
  a(f.group, f.of_model, f.state, f.exact_area, f.mesh_area, f.centroid, f.normal, f.nodes,
    f.facets, f.tets, f.parts);
}
void serialize(auto& a, Sizing& s) {
  a(s.even, s.edges_per_circle, s.layers, s.min_size, s.growth);
}

/// `nodes_needed` of each warning, to be written apart: warnings had none at first, and are still
/// written without.
std::vector<std::uint32_t> nodes_needed(const Report& report) {
  std::vector<std::uint32_t> needed;
  for (const Warning& warning : report.warnings) needed.push_back(warning.nodes_needed);
  return needed;
}
void put_nodes_needed(const std::vector<std::uint32_t>& needed, Report& report) {
  if (needed.size() != report.warnings.size())
    throw error::internal("store", "a stored revision has other warnings than numbers of nodes");
  for (std::size_t k = 0; k < needed.size(); ++k) report.warnings[k].nodes_needed = needed[k];
}

std::string write_documents(const Revision& revision) {
  std::ostringstream out(std::ios::binary);
  {
    cereal::PortableBinaryOutputArchive archive(out);
    const MeshGroups& groups = revision.output.groups;
    archive(std::uint32_t{kFormat}, revision.source, revision.meshed_source, revision.options,
            revision.edge_length, *revision.cells.parts, groups.facet_groups, groups.cell_owners,
            revision.output.map.transform_features, revision.report, revision.reference,
            revision.delaunay_state->mesh.super_vertices(), revision.delaunay_state->next_node_id,
            revision.delaunay_state->next_tet_id, revision.anchor != nullptr);
    if (revision.anchor) archive(revision.anchor->source);
    const Report& report = revision.report;
    archive(report.attempts, report.geometry, report.geometry_attempts, report.taken,
            revision.options.sizing, revision.rules_weakening, nodes_needed(report),
            revision.source.sizes, revision.meshed_source.sizes, revision.dense_places);
    if (revision.anchor) archive(revision.anchor->source.sizes);
    archive(revision.options.order, revision.output.mids.next_id, report.counts.mid_nodes,
            report.counts.straight_edges);
    archive(revision.source.groups, revision.meshed_source.groups, report.figures);
    if (revision.anchor) archive(revision.anchor->source.groups);
    archive(revision.options.hold);
  }
  return std::move(out).str();
}

Documents read_documents(const std::string& bytes, [[maybe_unused]] Revision& revision) {
  Documents documents;
  try {
    DocumentsArchive archive(bytes);
    std::uint32_t format = 0;
    archive(format);
    if (format < kNoAttempts || format > kFormat)
      throw error::internal("store", "a revision of another format");
#ifndef __clang_analyzer__  // it takes what cereal reads into by reference for uninitialised
    MeshGroups& groups = revision.output.groups;
    archive(revision.source, revision.meshed_source, revision.options, revision.edge_length,
            documents.parts, groups.facet_groups, groups.cell_owners,
            revision.output.map.transform_features, revision.report, revision.reference,
            documents.delaunay_state.mesh.super_vertices(), documents.delaunay_state.next_node_id,
            documents.delaunay_state.next_tet_id, documents.anchored);
    if (documents.anchored) archive(documents.anchor_source);
    if (format > kNoAttempts) archive(revision.report.attempts, revision.report.geometry);
    if (format > kNoGeometryAttempts) archive(revision.report.geometry_attempts);
    if (format > kNoTaken) archive(revision.report.taken);
    revision.options.sizing = {.even = true};
    if (format > kNoSizing) {
      std::vector<std::uint32_t> needed;
      archive(revision.options.sizing, revision.rules_weakening, needed);
      put_nodes_needed(needed, revision.report);
    }
    if (format > kNoSizes) {
      archive(revision.source.sizes, revision.meshed_source.sizes, revision.dense_places);
      if (documents.anchored) archive(documents.anchor_source.sizes);
    }
    Counts& counts = revision.report.counts;
    if (format > kNoOrder)
      archive(revision.options.order, revision.output.mids.next_id, counts.mid_nodes,
              counts.straight_edges);
    documents.has_figures = format > kNoGroups;
    if (documents.has_figures) {
      archive(revision.source.groups, revision.meshed_source.groups, revision.report.figures);
      if (documents.anchored) archive(documents.anchor_source.groups);
    }
    if (format > kNoHold) archive(revision.options.hold);
#endif
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    throw error::internal("store", std::string("a stored revision cannot be read: ") + e.what());
  }
  return documents;
}

}  // namespace remeshd
