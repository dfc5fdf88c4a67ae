#include "engine/remesh/first_format.h"

#include <cereal/archives/portable_binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/variant.hpp>
#include <cereal/types/vector.hpp>
#include <sstream>

#include "engine/base/error.h"
#include "engine/cellular/boundary_parts.h"
#include "engine/mesh/tet_boxes.h"
#include "engine/remesh/image_check.h"
#include "engine/remesh/master.h"

// One `serialize` a struct, in the order of its members; cereal finds them by their arguments.
namespace remeshd::kernel {

template <class A>
void serialize(A& a, BrepCell& c) {
  a(c.faces, c.volume);
}
template <class A>
void serialize(A& a, BrepFace& f) {
  a(f.cells, f.edges, f.area, f.swept_volume, f.centroid, f.label, f.triangles);
}
template <class A>
void serialize(A& a, BrepEdge& e) {
  a(e.kind, e.vertices, e.length, e.centre, e.axis, e.radius, e.tangents, e.points, e.chain,
    e.samples);
}
template <class A>
void serialize(A& a, BrepVertex& v) {
  a(v.position);
}
/// But for the CAD kernel's shapes, which parts of a boundary have none of.
template <class A>
void serialize(A& a, Brep& b) {
  a(b.cells, b.faces, b.edges, b.vertices, b.points, b.reference, b.scale);
}

}  // namespace remeshd::kernel

namespace remeshd {

namespace {
constexpr std::uint32_t kFormat = 8;  // of what was written last
}  // namespace

/// As a vector is.
template <class A, class T>
void load(A& a, Pages<T>& pages) {
  std::vector<T> values;
  a(values);
  pages = Pages<T>(values);
}
template <class A>
void serialize(A& a, Vec3& v) {
  a(v.x, v.y, v.z);
}
template <class A>
void serialize(A& a, Transform& t) {
  a(t.m);
}
template <class A>
void serialize(A& a, ProfileEntry& p) {
  a(p.x, p.y, p.through);
}
template <class A>
void serialize(A& a, PlacementSource& p) {
  a(p.origin, p.z_axis, p.x_axis);
}
template <class A>
void serialize(A& a, FeatureSource& f) {
  a(f.id, f.nature, f.type, f.parameters, f.profile, f.placement, f.reference);
}
template <class A>
void serialize(A& a, ModelSource& m) {
  a(m.name, m.unit, m.parameters, m.features);
}
template <class A>
void serialize(A& a, MeshOptions& o) {
  a(o.nodes, o.size, o.iterations, o.seed, o.inside, o.start, o.rebuild, o.clean_up, o.threshold);
}
template <class A>
void serialize(A& a, Support& s) {
  a(s.kind, s.entity);
}
template <class A>
void serialize(A& a, Box& b) {
  a(b.lo, b.hi);
}
template <class A>
void serialize(A& a, Surface& s) {
  a(s.kind, s.frame, s.r1, s.r2);
}
template <class A>
void serialize(A& a, FaceName& n) {
  a(n.feature, n.face);
}
template <class A>
void serialize(A& a, BoundaryPiece& p) {
  a(p.boundary, p.outward, p.surface, p.material_names, p.other_names, p.box);
}
template <class A>
void serialize(A& a, BoundaryParts& p) {
  a(p.brep, p.pieces);
}
template <class A>
void serialize(A& a, Cluster& c) {
  a(c.delaunay, c.delivered);
}
template <class A>
void serialize(A& a, Master& m) {
  a(m.mesh.far_corners());
  m.mesh.visit_named([&](const char*, auto& values) { a(values); });
  a(m.supports, m.tet_of_slot, m.clusters, m.next_node_id, m.next_tet_id);
}
template <class A>
void serialize(A& a, PagedMesh& m) {
  a(m.nodes, m.tets);
}
template <class A>
void serialize(A& a, MeshFacet& f) {
  a(f.nodes, f.tet, f.group);
}
template <class A>
void serialize(A& a, MeshGroups& g) {
  a(g.facets, g.facet_groups, g.tet_cell, g.cell_owners);
}
template <class A>
void serialize(A& a, NodeMap& m) {
  a(m.node_origin, m.original_node, m.node_transform, m.original_tet, m.transforms,
    m.transform_features);
}
template <class A>
void serialize(A& a, Delivery& d) {
  a(d.mesh, d.node_ids, d.tet_ids, d.groups, d.map);
}
template <class A>
void serialize(A& a, PhaseSeconds& s) {
  a(s.setup, s.optimise, s.extract, s.difference, s.copy, s.verify, s.total);
}
template <class A>
void serialize(A& a, Counts& c) {
  a(c.nodes, c.tets, c.boundary_facets, c.samples, c.active_samples, c.nodes_copied, c.nodes_new,
    c.free_at_start, c.free_at_end, c.free_per_iteration, c.nodes_kept, c.nodes_moved, c.tets_kept,
    c.iterations, c.nodes_inserted);
}
template <class A>
void serialize(A& a, Quality& q) {
  a(q.volume_length_mean, q.volume_length_p01, q.volume_length_min, q.dihedral_min, q.dihedral_max,
    q.volume, q.histogram);
}
template <class A>
void serialize(A& a, GroupArea& g) {
  a(g.group, g.exact_area, g.mesh_area);
}
template <class A>
void serialize(A& a, WearReference& r) {
  a(r.volume_length_mean, r.nodes_over_expected);
}
template <class A>
void serialize(A& a, VerificationFigures& v) {
  a(v.tets_proved, v.tets_inherited, v.chord_error, v.volume_error);
}
template <class A>
void serialize(A& a, Report& r) {
  a(r.revision, r.cached, r.way, r.seconds, r.counts, r.free_share, r.edge_length, r.volume,
    r.exact_volume, r.quality_before, r.quality, r.quality_away, r.sharp_tets, r.verification,
    r.groups, r.warnings);
}

Revision read_first_format(const std::string& bytes, const Run& run) {
  Revision revision;
  BoundaryParts parts;
  Master master;
  Anchor anchor;
  bool anchored = false;
  try {
    std::istringstream in(bytes, std::ios::binary);
    cereal::PortableBinaryInputArchive archive(in);
    std::uint32_t format = 0;
    archive(format);
    if (format != kFormat) throw error::internal("store", "a revision of another format");
#ifndef __clang_analyzer__  // it takes what cereal reads into by reference for uninitialised
    archive(revision.source, revision.meshed_source, revision.options, revision.edge_length, parts,
            master, revision.delivery, revision.report, revision.reference, anchored);
    if (anchored) archive(anchor.source, anchor.nodes, anchor.supports);
#endif
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    throw error::internal("store", std::string("a stored revision cannot be read: ") + e.what());
  }
  revision.model = evaluate(revision.source);
  revision.meshed_model = evaluate(revision.meshed_source);
  revision.cells = restore_cells(revision.model, std::move(parts));
  revision.boxes = boxes_round(revision.delivery.mesh);
  revision.measures = measure_tets(revision.delivery.mesh.nodes, revision.delivery.mesh.tets, run);
  revision.master = std::make_shared<const Master>(std::move(master));
  if (anchored) {
    anchor.model = evaluate(anchor.source);
    revision.anchor = std::make_shared<const Anchor>(std::move(anchor));
  }
  check_indices(revision);
  return revision;
}

}  // namespace remeshd
