#include "engine/cellular/check_cells.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/cellular/cell_samples.h"
#include "engine/cellular/features_at.h"

namespace remeshd {
namespace {

constexpr int kSamplesPerCell = 8;
// Of the feature's own volume. Integrals are exact to 1e-9, but curves of intersection with tori
// are approximated: 1.1e-6 was seen where nothing was wrong.
constexpr double kVolumeTolerance = 4e-6;

/// How far the facets of a cell stand off the true faces. Only samples deeper than twice this count
/// as proof that the owners are wrong.
double facet_gap(const kernel::Brep& brep, int cell, const Membership& membership) {
  double gap = 0;
  const auto look = [&](const Vec3& p) {
    double nearest = HUGE_VAL;
    for (const Solid& solid : membership.solids())
      for (const SolidFace& face : solid.faces())
        nearest = std::min(nearest, std::fabs(signed_distance(face.surface, p)));
    gap = std::max(gap, nearest);
  };
  for (const int f : brep.cells[cell].faces)
    for (const auto& [i, j, k] : brep.faces[f].triangles) {
      const Vec3 a = brep.points[i], b = brep.points[j], c = brep.points[k];
      look((a + b + c) / 3);
      look(0.5 * (a + b));
      look(0.5 * (b + c));
      look(0.5 * (c + a));
    }
  return gap;
}

/// The owners that are in one list only.
std::vector<int> difference(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> odd;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(odd));
  return odd;
}

Vec3 centre_of(const Box& box) { return 0.5 * (box.lo + box.hi); }

Vec3 some_point(const kernel::Brep& brep, int cell) {
  return brep.edges[brep.faces[brep.cells[cell].faces.front()].edges.front()].points.front();
}

/// Looks for a point with the cell's owners on the lines from the mean of its facets' centroids to
/// each centroid: for thin caps, all of whose facets meet at one node, so that rays from facet to
/// facet find none. Sets Cell::inside; false if it finds none either.
bool search(const kernel::Brep& brep, int c, const Membership& membership, Cell& cell) {
  std::vector<Vec3> centroids;
  Vec3 middle;
  for (const int f : brep.cells[c].faces)
    for (const auto& [i, j, k] : brep.faces[f].triangles) {
      centroids.push_back((brep.points[i] + brep.points[j] + brep.points[k]) / 3);
      middle += centroids.back();
    }
  middle = middle / static_cast<double>(centroids.size());
  std::vector<int> owners;
  for (const double t : {0.0, 0.5, 0.8})
    for (const Vec3& p : centroids) {
      cell.inside = middle + t * (p - middle);
      owners.clear();
      membership.owners(cell.inside, owners);
      if (owners == cell.owners) return true;
    }
  return false;
}

}  // namespace

void check_cells(CellComplex& cells, const kernel::Brep& brep, const FeatureModel& model,
                 const Membership& membership) {
  std::vector<int> owners;
  const auto owners_at = [&](const Vec3& p) -> const std::vector<int>& {
    owners.clear();
    membership.owners(p, owners);
    return owners;
  };
  for (int c = 0; c < static_cast<int>(cells.cells.size()); ++c) {
    Cell& cell = cells.cells[c];
    bool found = false;
    const std::vector<CellSample> samples = sample_cell(brep, c, kSamplesPerCell);
    for (const CellSample& sample : samples) {
      const bool agrees = owners_at(sample.point) == cell.owners;
      if (agrees && !found) {
        cell.inside = sample.point;
        found = true;
      }
      if (!agrees && sample.depth > 2 * facet_gap(brep, c, membership) &&
          winding_number(brep, c, sample.point) > 0.5)
        throw error::kernel_failure("a point inside a cell belongs to other features than the cell",
                                    sample.point, ids_of(model, difference(owners, cell.owners)));
    }
    // Thin curved cells: look all along the rays, and a little beyond both ends.
    for (const CellSample& sample : samples)
      for (const double t : {-0.2, -0.05, 0.05, 0.2, 0.8, 0.95, 1.05, 1.2}) {
        const Vec3 p = sample.from + t * (sample.to - sample.from);
        if (found || owners_at(p) != cell.owners) continue;
        cell.inside = p;
        found = true;
      }
    if (!found) found = search(brep, c, membership, cell);
    if (!found)
      throw error::kernel_failure("a cell holds no point that belongs to its owners",
                                  some_point(brep, c), ids_of(model, cell.owners));
  }
  for (int f = 0; f < static_cast<int>(model.features.size()); ++f) {
    double volume = 0;
    for (const Cell& cell : cells.cells)
      if (std::ranges::binary_search(cell.owners, f)) volume += cell.volume;
    const double exact = membership.solids()[f].volume();
    if (std::fabs(volume - exact) > kVolumeTolerance * exact)
      throw error::kernel_failure("the cells of a feature do not add up to its volume",
                                  centre_of(membership.solids()[f].bounds()),
                                  {model.features[f].id});
  }
}

}  // namespace remeshd
