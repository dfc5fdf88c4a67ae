#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/base/random.h"
#include "tests/campaign/rays.h"
#include "tests/campaign/verifier/mesh_surface.h"
#include "tests/campaign/verifier/tet_location.h"
#include "tests/campaign/verifier/verifier.h"
#include "tests/support/flat.h"

namespace remeshd::campaign {
namespace {

constexpr double kOnSurface = 1e-6;            // of the diagonal
constexpr int kLinesPerAxis = 24;              // squared, along each of the three axes
constexpr int kPoints = 4000;                  // inside or outside
constexpr int kSpiral = 2000;                  // directions round a node
constexpr int kDirections = 16, kReaches = 5;  // round a node between two surfaces
constexpr double kSlack = 2.0;                 // what rises of neighbouring chords may add up to

double six_volumes(const TetMesh& mesh, const Tet& t) {
  const Vec3& a = mesh.nodes[t[0]];
  return dot(cross(mesh.nodes[t[1]] - a, mesh.nodes[t[2]] - a), mesh.nodes[t[3]] - a);
}

class ShapeChecker {
 public:
  ShapeChecker(const Revision& revision, const std::vector<Triangle>& facets, Findings& findings)
      : revision_(revision),
        mesh_(test::flat(revision.output.mesh)),
        membership_(revision.model),
        rays_(membership_),
        diagonal_(membership_.bounds().diagonal()),
        tiny_(kOnSurface * diagonal_),
        surface_(mesh_, facets, membership_, tiny_),
        findings_(findings) {}

  void operator()() {
    check_boundary_nodes();
    check_coverage();
    check_points();
    check_centroids();
    check_volume();
  }

 private:
  /// Whether p lies in material however it is looked at, or in none.
  [[nodiscard]] bool inside_anyhow(const Vec3& p, double probe) const {
    if (membership_.inside(p)) return true;
    for (const Vec3& d : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
      if (membership_.inside(p + probe * d) || membership_.inside(p - probe * d)) return true;
    return false;
  }

  /// Every node of the boundary on a surface of a feature, with material on one side and none on
  /// the other; or as near to such a place as the chords of a curved rim beside it allow.
  void check_boundary_nodes() {
    std::vector<Vec3> inwards(mesh_.nodes.size()), outwards(mesh_.nodes.size());
    std::vector<char> boundary(mesh_.nodes.size(), 0);
    std::vector<double> chords(mesh_.nodes.size(), HUGE_VAL);
    for (std::size_t k = 0; k < surface_.facets().size(); ++k) {
      const Triangle& f = surface_.facets()[k];
      const double allowed = surface_.allowed(static_cast<std::int32_t>(k));
      const Vec3 n =
          cross(mesh_.nodes[f[1]] - mesh_.nodes[f[0]], mesh_.nodes[f[2]] - mesh_.nodes[f[0]]);
      for (const std::int32_t node : f) {
        boundary[node] = 1;
        outwards[node] += n / std::max(norm(n), 1e-300);
        chords[node] = std::min(chords[node], allowed);
      }
    }
    std::vector<std::vector<Vec3>> into(mesh_.nodes.size());
    for (const Tet& t : mesh_.tets) {
      const Vec3 c =
          0.25 * (mesh_.nodes[t[0]] + mesh_.nodes[t[1]] + mesh_.nodes[t[2]] + mesh_.nodes[t[3]]);
      for (const std::int32_t n : t)
        if (boundary[n]) into[n].push_back(normalised(c - mesh_.nodes[n]));
    }
    for (std::size_t n = 0; n < boundary.size(); ++n) {
      if (!boundary[n]) continue;
      const Vec3& p = mesh_.nodes[n];
      const std::vector<Surface> at = surfaces_at(p);
      if (at.empty()) {
        findings_.add("node on surface", "a boundary node on no feature's surface", p);
        continue;
      }
      if (!both_natures(p, into[n], outwards[n], at) &&
          !rays_.boundary_within(p, kSlack * chords[n]))
        findings_.add("node on boundary", "a boundary node with one nature all round", p);
    }
  }

  [[nodiscard]] std::vector<Surface> surfaces_at(const Vec3& p) const {
    std::vector<Surface> at;
    for (const Solid& solid : membership_.solids()) {
      if (!solid.bounds().contains(p, tiny_)) continue;
      for (const SolidFace& face : solid.faces())
        if (std::fabs(signed_distance(face.surface, p)) <= tiny_) at.push_back(face.surface);
    }
    return at;
  }

  [[nodiscard]] bool both_natures(const Vec3& p, const std::vector<Vec3>& into, const Vec3& outward,
                                  const std::vector<Surface>& at) const {
    bool any_inside = false, any_outside = false;
    const auto look_at = [&](const Vec3& q) {
      (membership_.inside(q) ? any_inside : any_outside) = true;
      return any_inside && any_outside;
    };
    const auto look = [&](const Vec3& d) { return look_at(p + 2 * tiny_ * d); };
    if (norm(outward) > 0 && look(normalised(outward))) return true;
    for (const Vec3& d : into)
      if (look(d) || look(-d)) return true;
    for (int k = 0; k < kSpiral; ++k)
      if (look(spiral_direction(k, kSpiral))) return true;
    // Between surfaces at so small an angle, or tangent, that no direction finds the middle.
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t j = i + 1; j < at.size(); ++j)
        for (int k = 0; k < kDirections * kReaches; ++k) {
          const double a = 2 * std::numbers::pi * (k % kDirections) / kDirections;
          const Vec3 n = normal(at[i], p), u = any_perpendicular(n), v = cross(n, u);
          const double reach = std::ldexp(tiny_, 1 + 2 * (k / kDirections));
          const Vec3 q = p + reach * (std::cos(a) * u + std::sin(a) * v);
          if (look_at(0.5 * (project(at[i], q) + project(at[j], q)))) return true;
        }
    return false;
  }

  /// Points of the model's boundary, where lines through the model change nature, are near the
  /// mesh's. The same lines give the model's volume.
  void check_coverage() {
    const Box box = membership_.bounds();
    const Vec3 size = box.hi - box.lo;
    Random random(11);
    double variance = 0;
    for (int axis = 0; axis < 3; ++axis) {
      double sum = 0, squares = 0;  // of chords; of differences between neighbours
      const std::array<Vec3, 3> step{Vec3{size.x, 0, 0}, Vec3{0, size.y, 0}, Vec3{0, 0, size.z}};
      const Vec3& across = step[(axis + 1) % 3];
      const Vec3& up = step[(axis + 2) % 3];
      const double length = norm(step[axis]);
      const Vec3 d = step[axis] / length;
      for (int i = 0; i < kLinesPerAxis; ++i) {
        double last = 0;
        for (int j = 0; j < kLinesPerAxis; ++j) {
          const Vec3 p = box.lo + ((i + random.uniform()) / kLinesPerAxis) * across +
                         ((j + random.uniform()) / kLinesPerAxis) * up - 0.01 * length * d;
          double chord = 0;
          for (const auto& [from, to] : without_films(rays_.material(p, d, 0, 1.02 * length))) {
            chord += to - from;
            for (const double t : {from, to}) check_near(p + t * d);
          }
          sum += chord;
          if (j > 0) squares += (chord - last) * (chord - last);
          last = chord;
        }
      }
      const int n = kLinesPerAxis * kLinesPerAxis;
      const double area = norm(across) * norm(up);
      volume_ += sum / n * area / 3;
      // One line in each square: what neighbours differ by tells how far a square's line is off.
      variance += area * area * squares / 2 / (static_cast<double>(n) * n) / 9;
    }
    deviation_ = std::sqrt(variance);
  }

  /// Stretches without walls and gaps that are thinner than nodes are near their surfaces: of what
  /// nearly coincides the model's cells may make one face.
  [[nodiscard]] std::vector<std::pair<double, double>> without_films(
      const std::vector<std::pair<double, double>>& stretches) const {
    std::vector<std::pair<double, double>> result;
    for (const auto& [from, to] : stretches) {
      if (!result.empty() && from - result.back().second <= tiny_)
        result.back().second = to;
      else
        result.emplace_back(from, to);
    }
    std::erase_if(result, [&](const auto& s) { return s.second - s.first <= tiny_; });
    return result;
  }

  /// The facet that p is least beyond the chords of, where it is beyond those of all.
  [[nodiscard]] std::optional<MeshSurface::Nearest> away_from_boundary(const Vec3& p) const {
    const MeshSurface::Nearest near = surface_.least_beyond(p, kSlack, 0.1 * diagonal_);
    if (near.distance <= kSlack * near.allowed + tiny_) return {};
    return near;
  }

  void check_near(const Vec3& p) {
    if (const auto near = away_from_boundary(p))
      findings_.add("coverage",
                    "a point of the model's boundary " + std::to_string(near->distance) +
                        " from the mesh's, allowed " + std::to_string(near->allowed),
                    p);
  }

  /// Random points: in the model if and only if in the mesh, but for those nearer to the mesh's
  /// boundary than its chords allow; and in one tet at most.
  void check_points() {
    const TetLocation location(mesh_);
    const Box box = membership_.bounds();
    const Vec3 size = box.hi - box.lo;
    Random random(13);
    for (int k = 0; k < kPoints; ++k) {
      const Vec3 p{box.lo.x + random.uniform(-0.02, 1.02) * size.x,
                   box.lo.y + random.uniform(-0.02, 1.02) * size.y,
                   box.lo.z + random.uniform(-0.02, 1.02) * size.z};
      const int tets = location.count(p);
      const bool inside = membership_.inside(p);
      if ((tets > 0) == inside && tets < 2) continue;
      if (tets > 1) {
        if (location.count(p + tiny_ * Vec3{0.3, 0.5, 0.7}) > 1)
          findings_.add("overlap", "a point in more than one tet", p);
        continue;
      }
      if (away_from_boundary(p))
        findings_.add("inside",
                      inside ? "a point of the model outside of the mesh"
                             : "a point outside of the model inside of the mesh",
                      p);
    }
  }

  /// Centroids of tets in material, or as near to the mesh's boundary as its chords allow; and the
  /// tet's cell has the features that contain the centroid as its owners.
  void check_centroids() {
    const MeshGroups& groups = revision_.output.groups;
    if (groups.tet_cell.size() != mesh_.tets.size()) {
      findings_.add("owners", "not one cell for each tet");
      return;
    }
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      const Tet& tet = mesh_.tets[t];
      const Vec3 c = 0.25 * (mesh_.nodes[tet[0]] + mesh_.nodes[tet[1]] + mesh_.nodes[tet[2]] +
                             mesh_.nodes[tet[3]]);
      if (!inside_anyhow(c, 0.01 * tiny_)) {
        if (away_from_boundary(c)) findings_.add("centroid", "a tet outside of the model", c);
        continue;
      }
      const std::int32_t cell = groups.tet_cell[t];
      if (cell < 0 || cell >= static_cast<std::int32_t>(groups.cell_owners.size())) {
        findings_.add("owners", "a cell that there is not", c);
        continue;
      }
      if (!owned_by(c, groups.cell_owners[cell]))
        findings_.add("owners", "a tet whose cell has other owners than its centroid", c);
    }
  }

  [[nodiscard]] bool owned_by(const Vec3& c, const std::vector<std::string>& named) const {
    std::vector<int> owners;
    for (const double probe : {0.0, 0.01 * tiny_})
      for (const Vec3& d : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0},
                            Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
        owners.clear();
        membership_.owners(c + probe * d, owners);
        std::vector<std::string> ids;
        for (const int k : owners) ids.push_back(revision_.model.features[k].id);
        if (ids == named) return true;
        if (probe == 0) break;
      }
    return false;
  }

  /// The mesh's volume is the model's within what chords cut off; the exact volume of the report is
  /// what lines through the model measure.
  void check_volume() {
    double volume = 0, chords = 0;
    for (const Tet& t : mesh_.tets) volume += six_volumes(mesh_, t) / 6;
    const auto& facets = surface_.facets();
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const Vec3& a = mesh_.nodes[facets[f][0]];
      const double area =
          0.5 * norm(cross(mesh_.nodes[facets[f][1]] - a, mesh_.nodes[facets[f][2]] - a));
      chords += area * surface_.rise(static_cast<std::int32_t>(f));
    }
    const double exact = revision_.report.exact_volume;
    if (std::fabs(volume - exact) > 1.5 * chords + 1e-6 * exact + rim_volume())
      findings_.add("volume", "the mesh has " + std::to_string(volume) + ", the model " +
                                  std::to_string(exact) + ", chords take " +
                                  std::to_string(chords));
    if (std::fabs(volume_ - exact) > 5 * deviation_ + 1e-6 * exact)
      findings_.add("exact volume", "the report says " + std::to_string(exact) + ", lines say " +
                                        std::to_string(volume_) + " +- " +
                                        std::to_string(deviation_));
    if (std::fabs(volume - revision_.report.volume) > 1e-6 * exact)
      findings_.add("reported volume", "the report says " +
                                           std::to_string(revision_.report.volume) +
                                           ", the tets have " + std::to_string(volume));
  }

  /// What chords of curved rims may take from the flat faces beside them, as a volume: a quarter of
  /// what the facets round them allow.
  [[nodiscard]] double rim_volume() const {
    double sum = 0;
    const auto& facets = surface_.facets();
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const auto index = static_cast<std::int32_t>(f);
      const double more = surface_.allowed(index) - surface_.rise(index);
      if (surface_.rise(index) > 0 || more <= tiny_) continue;
      sum += 0.25 * more * more * surface_.longest();
    }
    return sum;
  }

  const Revision& revision_;
  const TetMesh mesh_;
  const Membership membership_;
  const Rays rays_;
  const double diagonal_;
  const double tiny_;
  const MeshSurface surface_;
  Findings& findings_;
  double volume_ = 0, deviation_ = 0;
};

}  // namespace

void check_shape(const Revision& revision, const std::vector<Triangle>& facets,
                 Findings& findings) {
  if (facets.empty()) return;
  ShapeChecker(revision, facets, findings)();
}

}  // namespace remeshd::campaign
