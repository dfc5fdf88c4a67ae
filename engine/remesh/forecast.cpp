#include "engine/remesh/forecast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "engine/base/random.h"
#include "engine/base/stopwatch.h"
#include "engine/delaunay/delaunay_mesh.h"
#include "engine/model/solid.h"
#include "engine/nodes/density.h"
#include "engine/nodes/fill/fill.h"
#include "engine/sizing/size_rules.h"

namespace remeshd {
namespace {

/// Fitted to meshes of the seven cases and the detailed parts, of 1,000 to 200,000 nodes.
struct Cost {
  double bytes = 6e6, bytes_per_face = 0.25e6;  ///< of cells and boundary
  double bytes_per_node = 1330;                 ///< of an even mesh
  double graded = 420;                          ///< more bytes a node where it is not even
  double quadratic = 540;                       ///< more bytes a node where there are mid-nodes
  /// Time of a node, x that of a node of a small Delaunay mesh: per_node + on_boundary * s^power,
  /// where s is the share of the nodes that are on the boundary: thin models take many repairs.
  double per_node = 6, on_boundary = 125, power = 4;
};
constexpr Cost kCost;

struct BoundaryCount {
  double on_face = 0.92;  ///< nodes to a square of an edge length
  double largest = 2;     ///< x edge length: longer sides make a triangle be divided for counting
  double most = 0.95;     ///< of the nodes: no greater share is on the boundary
};
constexpr BoundaryCount kBoundaryCount;

/// The small Delaunay mesh by which this machine's speed is measured.
struct Yardstick {
  std::size_t nodes = 4000;
  int tries = 3;
};
constexpr Yardstick kYardstick;

struct DetailLimits {
  std::size_t most = 20;
};
constexpr DetailLimits kDetails;

/// Seconds per node of a Delaunay mesh on this machine: the least of some tries.
double delaunay_seconds() {
  Random random(1);
  const auto coordinate = [&] { return random.uniform(0, 1); };
  std::vector<Vec3> points(kYardstick.nodes);
  for (Vec3& p : points) p = {coordinate(), coordinate(), coordinate()};
  std::vector<std::int32_t> all(points.size());
  for (std::size_t n = 0; n < all.size(); ++n) all[n] = static_cast<std::int32_t>(n);
  double least = HUGE_VAL;
  for (int k = 0; k < kYardstick.tries; ++k) {
    const Stopwatch watch;
    DelaunayMesh mesh(Box{{0, 0, 0}, {1, 1, 1}});
    mesh.insert(points, all, Run{});
    least = std::fmin(least, watch.total());
  }
  return least / static_cast<double>(points.size());
}

double nodes_of(const Density& density, const FeatureModel& model, const CellularModel& cells,
                const SizeRules& rules, const MeshOptions& options, const Run& run) {
  const SizeField& sizes = density.sizes;
  if (sizes.even())
    return density.count ? *density.count : expected_nodes(cells.volume, cells.area, sizes.base());
  const Membership membership(model);
  const auto inside = [&](const Vec3& p) { return membership.inside(p); };
  const auto start = fill_graded({cells.boundary.bounds}, inside, sizes, options.seed, run);
  auto nodes = static_cast<double>(start.size());
  for (const ThinSide& side : rules.sides()) nodes += side.nodes(sizes(side.middle));
  return nodes;
}

/// Nodes that a field puts on a triangle.
double nodes_on(const std::array<Vec3, 3>& corners, const SizeField& sizes) {
  const auto& [a, b, c] = corners;
  const double h = sizes((1.0 / 3) * (a + b + c));
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  if (longest <= kBoundaryCount.largest * h)
    return kBoundaryCount.on_face * 0.5 * norm(cross(b - a, c - a)) / (h * h);
  const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  return nodes_on({a, ab, ca}, sizes) + nodes_on({ab, b, bc}, sizes) +
         nodes_on({ca, bc, c}, sizes) + nodes_on({ab, bc, ca}, sizes);
}

/// The share of the nodes that are on the boundary.
double share_on_boundary(const BoundaryModel& boundary, const SizeField& sizes, double nodes) {
  double on_boundary = 0;
  for (const BoundaryFace& face : boundary.faces)
    for (const auto& t : face.triangles)
      on_boundary += nodes_on({face.points[t[0]], face.points[t[1]], face.points[t[2]]}, sizes);
  return std::fmin(on_boundary / nodes, kBoundaryCount.most);
}

/// The faces that ask for less than the base size, each by its first name with the least length
/// asked for on it.
std::vector<Forecast::Detail> details_of(const Density& density, const FeatureModel& model,
                                         const CellularModel& cells, const SizeRules& rules) {
  const double base = density.sizes.base();
  if (density.sizes.even()) return {};
  std::map<std::pair<std::string, std::string>, double> least;
  const auto ask = [&](const std::string& feature, const std::string& face, double size) {
    if (size >= base) return;
    double& of_face = least.try_emplace({feature, face}, size).first->second;
    of_face = std::fmin(of_face, size);
  };
  for (const auto& detail : rules.asked_on_faces(density.weakening))
    if (const FaceName& name = cells.boundary.faces[detail.face].names.front(); name.feature >= 0)
      ask(model.features[name.feature].id, name.face, detail.size);
  std::set<std::pair<int, std::string>> on_boundary;
  for (const BoundaryFace& face : cells.boundary.faces)
    for (const FaceName& name : face.names) on_boundary.emplace(name.feature, name.face);
  for (const SizeControl& control : model.sizes)
    if (const auto* selected = std::get_if<std::vector<SizedFaces>>(&control.place))
      for (const SizedFaces& sized : *selected)
        for (const std::string& face : sized.on.faces)
          if (on_boundary.contains({sized.on.feature, face}))
            ask(model.features[sized.on.feature].id, face, sized.size);
  std::vector<Forecast::Detail> details;
  for (const auto& [name, size] : least) details.push_back({name.first, name.second, size});
  std::ranges::stable_sort(details, {}, &Forecast::Detail::size);
  if (details.size() > kDetails.most) details.resize(kDetails.most);
  return details;
}

}  // namespace

Forecast forecast(const Density& density, const FeatureModel& model, const CellularModel& cells,
                  const MeshOptions& options, double setup, const Run& run) {
  const Stopwatch watch;
  const SizeRules rules(cells.boundary, options.sizing, density.sizes.base(), run);
  const double nodes = nodes_of(density, model, cells, rules, options, run);
  setup += watch.total();  // a mesh has to be started too
  const BoundaryModel& boundary = cells.boundary;
  const double share = share_on_boundary(boundary, density.sizes, nodes);
  static const double kDelaunay = delaunay_seconds();
  const double per_node =
      kDelaunay * (kCost.per_node + kCost.on_boundary * std::pow(share, kCost.power));
  const double bytes_per_node = kCost.bytes_per_node + (density.sizes.even() ? 0 : kCost.graded) +
                                (options.order == 2 ? kCost.quadratic : 0);
  const double bytes = kCost.bytes +
                       kCost.bytes_per_face * static_cast<double>(boundary.faces.size()) +
                       bytes_per_node * nodes;
  return {.nodes = static_cast<std::uint32_t>(std::lround(nodes)),
          .bytes = static_cast<std::uint64_t>(bytes),
          .seconds = setup + per_node * nodes,
          .details = details_of(density, model, cells, rules)};
}

}  // namespace remeshd
