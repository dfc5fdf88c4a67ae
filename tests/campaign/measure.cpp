#include "tests/campaign/measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "engine/base/random.h"
#include "tests/campaign/contacts.h"
#include "tests/campaign/rays.h"

namespace remeshd::campaign {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kCusp = 0.2;      // degrees: a sharper angle is a tangent contact
constexpr double kSmooth = 0.2;    // degrees: a flatter edge is a smooth one
constexpr double kOnFace = 1e-6;   // of the diagonal
constexpr double kWedgeReach = 2;  // 1 / tan(30 degrees) and some for curvature
constexpr int kLeastPoints = 40;   // per face
constexpr int kMostPoints = 1500;

double to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double n = norm2(d);
  const double t = n == 0 ? 0 : std::clamp(dot(p - a, d) / n, 0.0, 1.0);
  return distance(p, a + t * d);
}

double to_edge(const Vec3& p, const BoundaryEdge& edge) {
  double best = HUGE_VAL;
  for (std::size_t k = 0; k + 1 < edge.points.size(); ++k)
    best = std::min(best, to_segment(p, edge.points[k], edge.points[k + 1]));
  return best;
}

Box box_of(const BoundaryEdge& edge) {
  Box box;
  for (const Vec3& p : edge.points) box.add(p);
  return box;
}

Vec3 outward(const BoundaryFace& face, const Vec3& p) {
  return (face.reversed ? -1.0 : 1.0) * normal(face.surface, p);
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b)) / kDegree;
}

class Measurer {
 public:
  Measurer(const FeatureModel& model, const BoundaryModel& boundary, double spacing)
      : model_(model),
        boundary_(boundary),
        membership_(model),
        rays_(membership_),
        spacing_(spacing),
        tolerance_(kOnFace * boundary.bounds.diagonal()) {}

  Measure operator()() {
    measure_edges();
    measure_angles();
    measure_corners();
    measure_apart();
    for (std::size_t f = 0; f < boundary_.faces.size(); ++f) measure_face(static_cast<int>(f));
    const Contacts contacts = find_contacts(model_, membership_);
    result_.tangent = result_.tangent || contacts.tangent > 0;
    result_.coincident = contacts.coincident > 0;
    result_.film = contacts.film > 0;
    return result_;
  }

 private:
  void measure_edges() {
    for (const BoundaryEdge& edge : boundary_.edges) {
      const bool round = edge.start == -1 && edge.end == -1;
      result_.edge = std::min(result_.edge, round ? edge.length / std::numbers::pi : edge.length);
    }
  }

  [[nodiscard]] bool share_feature(const BoundaryFace& a, const BoundaryFace& b) const {
    for (const FaceName& x : a.names)
      for (const FaceName& y : b.names)
        if (x.feature == y.feature) return true;
    return false;
  }

  /// Between the two faces of each edge, all along it.
  void measure_angles() {
    for (const BoundaryEdge& edge : boundary_.edges) {
      if (edge.faces.size() != 2) continue;
      const BoundaryFace &a = boundary_.faces[edge.faces[0]], &b = boundary_.faces[edge.faces[1]];
      for (const Vec3& p : edge.points) {
        const double turn = angle_between(outward(a, p), outward(b, p));
        result_.angle = std::min(result_.angle, 180 - turn);
        if (180 - turn < kCusp || (turn < kSmooth && !share_feature(a, b))) result_.tangent = true;
      }
    }
  }

  /// Direction in which the edge leaves one of its ends.
  static Vec3 leaves(const BoundaryEdge& edge, bool from_start) {
    const auto& p = edge.points;
    const std::size_t n = p.size();
    return normalised(from_start ? p[1] - p[0] : p[n - 2] - p[n - 1]);
  }

  /// Between edges of one face that meet at a vertex. The first chords of curved edges deviate from
  /// their tangents by 3 degrees each at most.
  void measure_corners() {
    struct End {
      Vec3 direction;
      bool straight;
      const BoundaryEdge* edge;
    };
    for (std::size_t v = 0; v < boundary_.vertices.size(); ++v) {
      std::vector<End> ends;
      for (const int e : boundary_.vertices[v].edges) {
        const BoundaryEdge& edge = boundary_.edges[e];
        const bool straight = edge.curve.kind == Curve::Kind::Line;
        const int vertex = static_cast<int>(v);
        if (edge.start == vertex) ends.push_back({leaves(edge, true), straight, &edge});
        if (edge.end == vertex) ends.push_back({leaves(edge, false), straight, &edge});
      }
      for (std::size_t i = 0; i < ends.size(); ++i)
        for (std::size_t j = i + 1; j < ends.size(); ++j) {
          if (!common_face(*ends[i].edge, *ends[j].edge)) continue;
          const double angle = angle_between(ends[i].direction, ends[j].direction);
          const double slack = 3.0 * (!ends[i].straight + !ends[j].straight);
          result_.angle = std::min(result_.angle, angle);
          if (angle <= slack + kCusp) result_.tangent = true;
        }
    }
  }

  static bool common_face(const BoundaryEdge& a, const BoundaryEdge& b) {
    return std::any_of(a.faces.begin(), a.faces.end(), [&](int f) {
      return std::find(b.faces.begin(), b.faces.end(), f) != b.faces.end();
    });
  }

  static bool share_vertex(const BoundaryEdge& a, const BoundaryEdge& b) {
    for (const int v : {a.start, a.end})
      if (v >= 0 && (v == b.start || v == b.end)) return true;
    return false;
  }

  void measure_apart() {
    std::vector<Box> boxes;
    for (const BoundaryEdge& edge : boundary_.edges) boxes.push_back(box_of(edge));
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = 0; j < boxes.size(); ++j) {
        const BoundaryEdge &a = boundary_.edges[i], &b = boundary_.edges[j];
        if (i == j || share_vertex(a, b)) continue;
        Box near = boxes[j];
        const double reach = std::min(result_.apart, 2 * spacing_);
        near.add(near.lo - Vec3{reach, reach, reach});
        near.add(near.hi + Vec3{reach, reach, reach});
        for (std::size_t k = 0; k + 1 < a.points.size(); ++k) {
          const double length = distance(a.points[k], a.points[k + 1]);
          const int steps = 1 + static_cast<int>(2 * length / spacing_);
          for (int s = 0; s <= steps; ++s) {
            const double t = static_cast<double>(s) / steps;
            const Vec3 p = (1 - t) * a.points[k] + t * a.points[k + 1];
            if (near.contains(p)) result_.apart = std::min(result_.apart, to_edge(p, b));
          }
        }
      }
  }

  /// Points all over a face, by area.
  [[nodiscard]] std::vector<Vec3> scatter(const BoundaryFace& face) {
    std::vector<double> sums;
    double sum = 0;
    for (const auto& [i, j, k] : face.triangles) {
      sum += 0.5 * norm(cross(face.points[j] - face.points[i], face.points[k] - face.points[i]));
      sums.push_back(sum);
    }
    std::vector<Vec3> result;
    if (sum == 0) return result;
    const int count =
        std::clamp(static_cast<int>(face.area / (spacing_ * spacing_)), kLeastPoints, kMostPoints);
    for (int n = 0; n < count; ++n) {
      const double at = (n + random_.uniform()) * sum / count;
      const auto t = static_cast<std::size_t>(
          std::min<std::ptrdiff_t>(std::lower_bound(sums.begin(), sums.end(), at) - sums.begin(),
                                   static_cast<std::ptrdiff_t>(sums.size()) - 1));
      double u = random_.uniform(), v = random_.uniform();
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      const auto& [i, j, k] = face.triangles[t];
      result.push_back(project(face.surface, face.points[i] +
                                                 u * (face.points[j] - face.points[i]) +
                                                 v * (face.points[k] - face.points[i])));
    }
    return result;
  }

  void measure_face(int index) {
    const BoundaryFace& face = boundary_.faces[index];
    double inner = 0;
    for (const Vec3& p : scatter(face)) {
      double from_edges = HUGE_VAL;
      for (const int e : face.edges)
        from_edges = std::min(from_edges, to_edge(p, boundary_.edges[e]));
      inner = std::max(inner, from_edges);
      const Vec3 n = outward(face, p);
      cast(face, p, -n, from_edges, result_.wall);
      cast(face, p, n, from_edges, result_.gap);
    }
    result_.face = std::min(result_.face, face.edges.empty() ? std::sqrt(face.area) : 2 * inner);
  }

  void cast(const BoundaryFace& face, const Vec3& p, const Vec3& d, double from_edges,
            double& least) {
    const double reach = std::min(least, 3 * spacing_ / 0.7);
    const double t = rays_.first_change(p, d, tolerance_, reach);
    if (t >= reach) return;
    if (from_edges <= kWedgeReach * t && meet_near(face, p, p + t * d, kWedgeReach * t)) return;
    least = t;
  }

  /// Whether the face that q lies on meets this one, at an edge or vertex near p.
  [[nodiscard]] bool meet_near(const BoundaryFace& face, const Vec3& p, const Vec3& q,
                               double reach) const {
    for (const int e : face.edges) {
      const BoundaryEdge& edge = boundary_.edges[e];
      if (to_edge(p, edge) > reach) continue;
      for (const int f : edge.faces)
        if (&boundary_.faces[f] != &face && on(boundary_.faces[f], q)) return true;
      for (const int v : {edge.start, edge.end}) {
        if (v < 0 || distance(p, boundary_.vertices[v].position) > reach) continue;
        for (const int other : boundary_.vertices[v].edges)
          for (const int f : boundary_.edges[other].faces)
            if (&boundary_.faces[f] != &face && on(boundary_.faces[f], q)) return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool on(const BoundaryFace& face, const Vec3& q) const {
    return std::fabs(signed_distance(face.surface, q)) <= tolerance_;
  }

  const FeatureModel& model_;
  const BoundaryModel& boundary_;
  const Membership membership_;
  const Rays rays_;
  const double spacing_;
  const double tolerance_;
  Random random_{1};
  Measure result_;
};

}  // namespace

double Measure::smallest() const { return std::min({edge, face, wall, gap, apart}); }

bool Measure::good_natured(double length) const {
  return smallest() >= length && !tangent && !film && !wedge();
}

Measure measure(const FeatureModel& model, const BoundaryModel& boundary, double spacing) {
  return Measurer(model, boundary, spacing)();
}

}  // namespace remeshd::campaign
