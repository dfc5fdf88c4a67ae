#pragma once

#include <cereal/types/array.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/variant.hpp>
#include <cereal/types/vector.hpp>

#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/revision/revision.h"

// How structs are written that have been written in the same way ever since: one `serialize` each,
// in the order of its members; cereal finds them by their arguments. A struct that changes leaves
// this file: what reads older revisions keeps the old form, what writes takes the new one.
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
void serialize(A& a, ParameterSource& p) {
  a(p.name, p.value, p.lower, p.upper, p.integer, p.unit, p.description);
}
template <class A>
void serialize(A& a, MeshOptions& o) {
  a(o.nodes, o.size, o.iterations, o.seed, o.inside, o.start, o.rebuild, o.clean_up, o.threshold);
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
void serialize(A& a, QualityReference& r) {
  a(r.volume_length_mean, r.nodes_over_expected);
}
template <class A>
void serialize(A& a, VerificationFigures& v) {
  a(v.tets_proved, v.tets_inherited, v.chord_error, v.volume_error);
}
template <class A>
void serialize(A& a, Warning& w) {
  a(w.code, w.message, w.features, w.groups, w.point);
}

}  // namespace remeshd
