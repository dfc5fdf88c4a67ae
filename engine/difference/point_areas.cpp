#include "engine/difference/point_areas.h"

#include <algorithm>
#include <cmath>

#include "engine/kernel/brep.h"

namespace remeshd {
namespace {

/// The surface of the model that a face lies on: the one that all corners of its facets are on.
/// Between the corners, facets cut round faces short and may come nearer to another surface.
const Surface& surface_of(const Membership& model, const std::vector<int>& owners,
                          const kernel::Brep& brep, const kernel::BrepFace& face) {
  const Surface* best = nullptr;
  double least = HUGE_VAL;
  for (const int owner : owners)
    for (const SolidFace& candidate : model.solids()[owner].faces()) {
      double off = 0;
      for (const auto& t : face.triangles)
        for (const int p : t)
          off = std::max(off, std::fabs(signed_distance(candidate.surface, brep.points[p])));
      if (off < least) {
        least = off;
        best = &candidate.surface;
      }
    }
  return *best;
}

/// `count` points spread evenly over the facets of a face.
std::vector<Vec3> spread(const kernel::Brep& brep, const kernel::BrepFace& face, int count) {
  const auto area = [&](const std::array<int, 3>& t) {
    return triangle_area(brep.points[t[0]], brep.points[t[1]], brep.points[t[2]]);
  };
  double whole = 0;
  for (const auto& t : face.triangles) whole += area(t);
  std::vector<Vec3> points;
  double due = 0.5, u = 0.5, v = 0.5;
  for (const auto& t : face.triangles) {
    due += count * area(t) / whole;
    for (; due >= 1; due -= 1) {
      // Roberts's R2 sequence, folded into the triangle.
      u = std::fmod(u + 0.7548776662466927, 1.0);
      v = std::fmod(v + 0.5698402909980532, 1.0);
      const auto [x, y] = u + v > 1 ? std::pair(1 - u, 1 - v) : std::pair(u, v);
      points.push_back((1 - x - y) * brep.points[t[0]] + x * brep.points[t[1]] +
                       y * brep.points[t[2]]);
    }
  }
  return points;
}

}  // namespace

std::vector<ClassTotals> estimate_areas(const PointClasses& classes, const ModelView& original,
                                        const ModelView& modified, int samples, const Run& run) {
  std::vector<ClassTotals> totals(classes.features().size());
  const double probe = 1e-9 * classes.modified().bounds().diagonal();
  for (const bool is_original : {false, true}) {
    const CellComplex& cells = (is_original ? original : modified).cells->complex(run);
    const Membership& model = is_original ? classes.original() : classes.modified();
    double whole = 0;
    for (const CellFace& face : cells.faces) whole += face.area;
    for (std::size_t i = 0; i < cells.faces.size(); ++i) {
      run.poll();
      const CellFace& face = cells.faces[i];
      const int count = std::max(16, static_cast<int>(samples * face.area / whole));
      const std::vector<Vec3> points = spread(*cells.brep, cells.brep->faces[i], count);
      const Surface& surface = surface_of(model, face.owners, *cells.brep, cells.brep->faces[i]);
      for (const Vec3& raw : points) {
        const Vec3 p = project(surface, raw), n = normal(surface, raw);
        for (std::size_t f = 0; f < totals.size(); ++f) {
          const FeaturePair& pair = classes.features()[f];
          if (!std::ranges::binary_search(face.owners, is_original ? pair.original : pair.modified))
            continue;
          const Transform to_modified = is_original ? rigid_inverse(pair.to_original) : Transform{};
          const DifferenceClass value =
              classes.face(static_cast<int>(f), to_modified.apply(p), to_modified.rotate(n), probe);
          // What both models have is counted on the faces of the modified one.
          const bool old = value == DifferenceClass::OldYes || value == DifferenceClass::OldNo;
          if (old == is_original && value != DifferenceClass::Artefact)
            totals[f][value] += face.area / static_cast<double>(points.size());
        }
      }
    }
  }
  return totals;
}

}  // namespace remeshd
