#include "tests/campaign/parts/drawing.h"

#include <algorithm>
#include <cmath>

#include "engine/base/random.h"
#include "tests/campaign/contacts.h"
#include "tests/campaign/rays.h"

namespace remeshd::campaign {
namespace {

constexpr int kPoints = 24;          // of a face
constexpr double kOnSurface = 1e-6;  // of the diagonal

class Looker {
 public:
  Looker(const FeatureModel& model, const BoundaryModel& boundary)
      : model_(model),
        boundary_(boundary),
        membership_(model),
        rays_(membership_),
        tolerance_(kOnSurface * boundary.bounds.diagonal()) {
    for (const BoundaryFace& face : boundary.faces) {
      double least = HUGE_VAL;
      for (const FaceName& name : face.names)
        least = std::min(least, least_size(model.features[name.feature]));
      details_.push_back(least);
      boxes_.push_back(grown(box_of(face.points), tolerance_));
    }
  }

  Drawing operator()() {
    for (const BoundaryEdge& edge : boundary_.edges) look_at(edge);
    for (std::size_t f = 0; f < boundary_.faces.size(); ++f) look_at(f);
    const Contacts contacts = find_contacts(model_, membership_);
    result_.touching = contacts.tangent + contacts.film;
    return result_;
  }

 private:
  void note(double length, double detail) {
    result_.narrowest = std::min(result_.narrowest, length / detail);
  }

  void look_at(const BoundaryEdge& edge) {
    if (edge.start == -1) return;
    double detail = HUGE_VAL;
    for (const int f : edge.faces) detail = std::min(detail, details_[f]);
    note(edge.length, detail);
  }

  void look_at(std::size_t f) {
    const BoundaryFace& face = boundary_.faces[f];
    std::vector<double> sums;
    double sum = 0;
    for (const auto& [i, j, k] : face.triangles)
      sums.push_back(sum += triangle_area(face.points[i], face.points[j], face.points[k]));
    if (sum == 0) return;
    for (int n = 0; n < kPoints; ++n) {
      const double at = (n + random_.uniform()) * sum / kPoints;
      const auto t =
          std::min<std::size_t>(std::ranges::lower_bound(sums, at) - sums.begin(), sums.size() - 1);
      const auto& [i, j, k] = face.triangles[t];
      double u = random_.uniform(), v = random_.uniform();
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec3 p = project(face.surface, face.points[i] + u * (face.points[j] - face.points[i]) +
                                               v * (face.points[k] - face.points[i]));
      const Vec3 outward = outward_normal(face, p);
      cast(f, p, outward);
      cast(f, p, -outward);
    }
  }

  /// The chord to the next face, unless it is one that meets this one at an edge.
  void cast(std::size_t f, const Vec3& p, const Vec3& d) {
    const double reach = kNarrow * details_[f];
    const double t = rays_.first_change(p, d, tolerance_, reach);
    if (t >= reach) return;
    const Vec3 q = p + t * d;
    for (std::size_t g = 0; g < boundary_.faces.size(); ++g)
      if (boxes_[g].contains(q) && !meet(f, g) &&
          std::fabs(signed_distance(boundary_.faces[g].surface, q)) <= tolerance_)
        note(t, std::min(details_[f], details_[g]));
  }

  [[nodiscard]] bool meet(std::size_t f, std::size_t g) const {
    if (f == g) return false;
    const std::vector<int>&a = boundary_.faces[f].edges, &b = boundary_.faces[g].edges;
    return std::ranges::any_of(a, [&](int edge) { return std::ranges::binary_search(b, edge); });
  }

  const FeatureModel& model_;
  const BoundaryModel& boundary_;
  const Membership membership_;
  const Rays rays_;
  const double tolerance_;
  std::vector<double> details_;  ///< of each face, the least size of its features
  std::vector<Box> boxes_;       ///< round each face
  Random random_{1};
  Drawing result_;
};

}  // namespace

double least_size(const Feature& feature) {
  const Box box = local_bounds(feature.shape);
  const Vec3 extent = box.hi - box.lo;
  return std::min({extent.x, extent.y, extent.z});
}

Drawing look_at_drawing(const FeatureModel& model, const BoundaryModel& boundary) {
  return Looker(model, boundary)();
}

}  // namespace remeshd::campaign
