#pragma once

#include <cereal/types/array.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/variant.hpp>
#include <cereal/types/vector.hpp>

#include "engine/cellular/boundary_model/boundary_parts.h"
#include "engine/revision/revision.h"

// How structs are written whose stored form has never changed: one `serialize` each, in the order
// of its members; cereal finds them by their arguments. A struct whose form changes leaves this
// file: what reads older revisions keeps the old form, what writes takes the new one.
namespace remeshd::kernel {

void serialize(auto& a, BrepCell& c) { a(c.faces, c.volume); }
void serialize(auto& a, BrepFace& f) {
  a(f.cells, f.edges, f.area, f.swept_volume, f.centroid, f.label, f.triangles);
}
void serialize(auto& a, BrepEdge& e) {
  a(e.kind, e.vertices, e.length, e.centre, e.axis, e.radius, e.tangents, e.points, e.chain,
    e.samples);
}
void serialize(auto& a, BrepVertex& v) { a(v.position); }
/// But for the CAD kernel's shapes, of which the parts of a boundary have none.
void serialize(auto& a, Brep& b) {
  a(b.cells, b.faces, b.edges, b.vertices, b.points, b.reference, b.scale);
}

}  // namespace remeshd::kernel

namespace remeshd {

void serialize(auto& a, Vec3& v) { a(v.x, v.y, v.z); }
void serialize(auto& a, Transform& t) { a(t.m); }
void serialize(auto& a, ProfileEntry& p) { a(p.x, p.y, p.through); }
void serialize(auto& a, PlacementSource& p) { a(p.origin, p.z_axis, p.x_axis); }
void serialize(auto& a, FeatureSource& f) {
  a(f.id, f.nature, f.type, f.parameters, f.profile, f.placement, f.reference);
}
void serialize(auto& a, ParameterSource& p) {
  a(p.name, p.value, p.lower, p.upper, p.integer, p.unit, p.description);
}
/// But for the sizing, the order and the hold, which came later and are written apart.
void serialize(auto& a, MeshOptions& o) {
  a(o.nodes, o.size, o.iterations, o.seed, o.inside, o.start, o.rebuild, o.clean_up, o.threshold);
}
void serialize(auto& a, Box& b) { a(b.lo, b.hi); }
void serialize(auto& a, Surface& s) { a(s.kind, s.frame, s.r1, s.r2); }
void serialize(auto& a, FaceName& n) { a(n.feature, n.face); }
void serialize(auto& a, BoundaryPiece& p) {
  a(p.boundary, p.outward, p.surface, p.material_names, p.other_names, p.box);
}
void serialize(auto& a, BoundaryParts& p) { a(p.brep, p.pieces); }
/// But for the mid-nodes and straight edges, which came later and are written apart.
void serialize(auto& a, Counts& c) {
  a(c.nodes, c.tets, c.boundary_facets, c.samples, c.active_samples, c.nodes_copied, c.nodes_new,
    c.free_at_start, c.free_at_end, c.free_per_iteration, c.nodes_kept, c.nodes_moved, c.tets_kept,
    c.iterations, c.nodes_inserted);
}
void serialize(auto& a, Quality& q) {
  a(q.volume_length_mean, q.volume_length_p01, q.volume_length_min, q.dihedral_min, q.dihedral_max,
    q.volume, q.histogram);
}
void serialize(auto& a, GroupArea& g) { a(g.group, g.exact_area, g.mesh_area); }
void serialize(auto& a, QualityReference& r) { a(r.volume_length_mean, r.nodes_over_expected); }
void serialize(auto& a, VerificationFigures& v) {
  a(v.tets_proved, v.tets_inherited, v.chord_error, v.volume_error);
}
void serialize(auto& a, Warning& w) { a(w.code, w.message, w.features, w.groups, w.point); }

}  // namespace remeshd
