#include "engine/nodes/active_faces.h"

#include <algorithm>

#include "engine/boundary/lattice.h"
#include "engine/nodes/nearest.h"

namespace remeshd {

namespace {

constexpr double kSpacing = 0.5;  // of the edge length

/// Frees nodes at active faces. `visit` looks at the faces of one solid, moved by `motion`, where
/// they lie in `where`; `back` is the inverse of `motion`.
class FaceVisitor {
 public:
  FaceVisitor(CopiedNodes& nodes, const CopyPlan& plan, const SizeField& sizes, const Run& run)
      : nodes_(nodes),
        plan_(plan),
        grid_(nodes.positions, kGridCell * sizes.grid_length()),
        sizes_(sizes),
        run_(run) {}

  void visit(const Solid& solid, const Transform& motion, const Transform& back,
             const std::vector<Box>& where) {
    const Box bounds = moved(solid.bounds(), motion);
    for (std::size_t b = 0; b < where.size(); ++b) {
      const Box overlap = intersection(bounds, where[b]);
      if (overlap.empty()) continue;
      const Box reach = grown(overlap, plan_.probe());
      run_.poll();
      for (const SolidFace& face : solid.faces()) {
        Surface surface = face.surface;
        surface.frame = motion.is_identity() ? surface.frame : motion * surface.frame;
        Random random(1);  // there is no jitter: it only draws where rows begin
        for (const SizeField::EvenPart& part : sizes_.even_parts(overlap, surface)) {
          const Box within = part.reach(reach);
          visit_lattice(surface, part.box, within, kSpacing * part.length, 0, random,
                        [&](const Vec3& p) {
                          if (!reach.contains(p) || !part.holds(p)) return;
                          for (std::size_t earlier = 0; earlier < b; ++earlier)
                            if (where[earlier].contains(p)) return;
                          look_at(solid, back, p, normal(surface, p));
                        });
        }
      }
    }
  }

 private:
  void look_at(const Solid& solid, const Transform& back, const Vec3& p, const Vec3& n) {
    const Vec3 off = plan_.probe() * n;
    if (solid.contains(back.apply(p + off)) == solid.contains(back.apply(p - off))) return;
    if (!plan_.active_face(p, n)) return;
    const std::int32_t node = grid_.nearest(p);
    if (node >= 0) nodes_.state[node] = NodeState::Free;
  }

  CopiedNodes& nodes_;
  const CopyPlan& plan_;
  const NearestNode grid_;
  const SizeField& sizes_;
  const Run& run_;
};

}  // namespace

void free_at_active_faces(CopiedNodes& nodes, const CopyPlan& plan, const SizeField& sizes,
                          const Run& run) {
  FaceVisitor visitor(nodes, plan, sizes, run);
  for (const Solid& solid : plan.modified().solids()) visitor.visit(solid, {}, {}, plan.changed());
  for (std::size_t t = 0; t < plan.transforms().size(); ++t) {
    // Copies made by this transformation end up within its features' new extent.
    std::vector<Box> where;
    if (plan.transforms()[t].is_identity()) {
      where = plan.changed();
    } else {
      for (const SourceFeature& s : plan.sources())
        if (s.transform == static_cast<std::int32_t>(t) && s.volume > 0)
          where.push_back(plan.modified().solids()[s.modified].bounds());
    }
    for (std::size_t o = 0; o < plan.original().solids().size(); ++o) {
      const auto visited = [&](const SourceFeature& s) {  // above, as a solid of the modified model
        return s.same_shape && s.original == static_cast<int>(o) &&
               s.transform == static_cast<std::int32_t>(t);
      };
      if (std::ranges::none_of(plan.sources(), visited))
        visitor.visit(plan.original().solids()[o], plan.transforms()[t], plan.inverses()[t], where);
    }
  }
}

}  // namespace remeshd
