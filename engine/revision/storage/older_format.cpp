#include "engine/revision/storage/older_format.h"

#include <string_view>

#include "engine/base/error.h"
#include "engine/mesh/tet_boxes.h"
#include "engine/revision/delaunay_state.h"
#include "engine/revision/storage/stored_archive.h"
#include "engine/revision/storage/stored_revision_check.h"
#include "engine/revision/storage/stored_types.h"

namespace remeshd {

namespace {

constexpr std::uint32_t kOldest = 8;  // what older programs wrote is refused
constexpr std::uint32_t kTypedWarnings = 9;

/// A type of its own, so that the structs below may be read otherwise than they are written today.
class OlderArchive : public StoredArchive<OlderArchive> {
 public:
  explicit OlderArchive(std::string_view bytes) : StoredArchive(this, bytes) {
    take(&format, sizeof format);
    if (format < kOldest || format > kTypedWarnings)
      throw error::internal("store", "a revision of another format");
  }

  std::uint32_t format = 0;
};

}  // namespace
}  // namespace remeshd

/// cereal asks for the matching output archive: enumerators are read as that writes them.
template <>
struct cereal::traits::detail::get_output_from_input<remeshd::OlderArchive> {
  using type = cereal::PortableBinaryOutputArchive;
};

namespace remeshd {
namespace {

/// A warning of a format that had sentences without codes.
Warning typed(const std::string& sentence) {
  WarningCode code = WarningCode::Fallback;
  if (sentence.starts_with("the mesh had worn")) code = WarningCode::Renewed;
  if (sentence.find(" nodes were inserted") != std::string::npos) code = WarningCode::NodesInserted;
  return {.code = code, .message = sentence};
}

}  // namespace

// One `load` for each struct that is now written in another way, or not in one piece any more.

template <class T>
void load(OlderArchive& a, CowVector<T>& pages) {
  std::vector<T> values;
  a(values);
  pages = CowVector<T>(values);
}
void load(OlderArchive& a, ModelSource& m) {
  a(m.name, m.unit);
  if (a.format >= kTypedWarnings) {
    a(m.parameters);
  } else {
    std::map<std::string, Scalar> parameters;
    a(parameters);
    for (auto& [name, value] : parameters)
      m.parameters.push_back({.name = name, .value = std::move(value)});
  }
  a(m.features);
}
void load(OlderArchive& a, Support& s) { a(s.kind, s.entity); }
void load(OlderArchive& a, Cavity& c) { a(c.delaunay, c.output); }
void load(OlderArchive& a, DelaunayState& m) {
  a(m.mesh.super_vertices());
  m.mesh.visit_named([&](const char*, auto& values) { a(values); });
  a(m.supports, m.tet_of_slot, m.cavities, m.next_node_id, m.next_tet_id);
}
void load(OlderArchive& a, PagedMesh& m) { a(m.nodes, m.tets); }
void load(OlderArchive& a, MeshFacet& f) { a(f.nodes, f.tet, f.group); }
void load(OlderArchive& a, MeshGroups& g) {
  a(g.facets, g.facet_groups, g.tet_cell, g.cell_owners);
}
void load(OlderArchive& a, NodeMap& m) {
  a(m.node_origin, m.original_node, m.node_transform, m.original_tet, m.transforms,
    m.transform_features);
}
void load(OlderArchive& a, OutputMesh& d) { a(d.mesh, d.node_ids, d.tet_ids, d.groups, d.map); }
void load(OlderArchive& a, PhaseSeconds& s) {
  a(s.setup, s.optimise, s.extract, s.difference, s.copy, s.verify, s.total);
}
void load(OlderArchive& a, Report& r) {
  a(r.revision, r.cached, r.strategy, r.seconds, r.counts, r.free_share, r.edge_length, r.volume,
    r.exact_volume, r.quality_before, r.quality, r.quality_away, r.sharp_tets, r.verification,
    r.groups);
  if (a.format >= kTypedWarnings) {
    a(r.last_resort_share, r.warnings);
    return;
  }
  r.last_resort_share = r.strategy == MeshStrategy::TetGen ? 1 : 0;
  std::vector<std::string> sentences;
  a(sentences);
  for (const std::string& sentence : sentences) r.warnings.push_back(typed(sentence));
}

Revision read_older_format(const std::string& bytes, const Run& run) {
  Revision revision;
  BoundaryParts parts;
  DelaunayState delaunay_state;
  Anchor anchor;
  bool anchored = false;
  try {
    OlderArchive archive(bytes);
#ifndef __clang_analyzer__  // it takes what cereal reads into by reference for uninitialised
    archive(revision.source, revision.meshed_source, revision.options, revision.edge_length, parts,
            delaunay_state, revision.output, revision.report, revision.reference, anchored);
    revision.options.sizing = {.even = true};
    if (anchored) archive(anchor.source, anchor.nodes, anchor.supports);
#endif
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    throw error::internal("store", std::string("a stored revision cannot be read: ") + e.what());
  }
  revision.model = evaluate(revision.source);
  revision.meshed_model = evaluate(revision.meshed_source);
  check_parts(parts, revision.model);
  revision.cells = restore_cells(revision.model, std::move(parts));
  revision.delaunay_state = std::make_shared<const DelaunayState>(std::move(delaunay_state));
  if (anchored) {
    anchor.model = evaluate(anchor.source);
    revision.anchor = std::make_shared<const Anchor>(std::move(anchor));
  }
  check_indices(revision);
  revision.boxes = boxes_round(revision.output.mesh);
  revision.measures = measure_tets(revision.output.mesh.nodes, revision.output.mesh.tets, run);
  return revision;
}

}  // namespace remeshd
