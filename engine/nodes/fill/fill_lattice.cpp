#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/base/random.h"
#include "engine/nodes/fill/fill.h"
#include "engine/nodes/fill/turned_lattice.h"

namespace remeshd {

namespace {

struct LatticeFilling {
  /// Share of the lattice constant by which a node may be off its place along each axis. From .02
  /// to .1 the meshes are equally good; without it cospherical nodes leave worse ones.
  double jitter = 0.05;
  /// x the count: a lattice for a count may hold so many nodes, which are then thinned out evenly.
  double surplus = 1.004;
  int tries = 12;       ///< to find the lattice constant for a count
  int empty_tries = 3;  ///< of these while there is no node; each halves the constant
};
constexpr LatticeFilling kLatticeFilling;
constexpr double kShaken = 2;  // x jitter: no node is further from its place than sqrt(3) of it

/// One lattice through all of space.
class Lattice {
 public:
  Lattice(double constant, std::uint64_t seed) : lattice_(constant, seed), seed_(seed) {}

  [[nodiscard]] const TurnedLattice& turned() const { return lattice_; }

  /// Calls `visit(p)` for the nodes in a layer of cubes that may be in the box, in the order of the
  /// lattice.
  template <class Visit>
  void for_each_in(const TurnedLattice::Cubes& cubes, std::size_t layer, const Box& box,
                   const Visit& visit) const {
    const double shaken = kShaken * kLatticeFilling.jitter * lattice_.constant();
    const long z = cubes.lo[2] + static_cast<long>(layer);
    for (long y = cubes.lo[1]; y <= cubes.hi[1]; ++y)
      for (long x = cubes.lo[0]; x <= cubes.hi[0]; ++x)
        for (const int centre : {0, 1}) {
          const auto along = [&](long v) { return static_cast<double>(v) + 0.5 * centre; };
          if (box.contains(lattice_.place(along(x), along(y), along(z)), shaken))
            visit(node(x, y, z, centre));
        }
  }

 private:
  /// The jitter depends on the place in the lattice alone: overlapping boxes see the same node.
  [[nodiscard]] Vec3 node(long x, long y, long z, int centre) const {
    Random random = TurnedLattice::draw({2 * x + centre, y, z}, seed_);
    const auto along = [&](long v) {
      return static_cast<double>(v) + 0.5 * centre +
             random.uniform(-kLatticeFilling.jitter, kLatticeFilling.jitter);
    };
    const double u = along(x), v = along(y), w = along(z);
    return lattice_.place(u, v, w);
  }

  TurnedLattice lattice_;
  std::uint64_t seed_;
};

std::vector<Vec3> nodes_inside(const Lattice& lattice, const std::vector<Box>& boxes,
                               const InsideTest& inside, const Run& run) {
  std::vector<Vec3> nodes;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    if (boxes[b].empty()) continue;
    const TurnedLattice::Cubes cubes = lattice.turned().cubes_of(boxes[b]);
    const auto found = collect_in_blocks<Vec3>(
        cubes.layers(), 1, run, [&](std::size_t layer, std::size_t, std::vector<Vec3>& in_layer) {
          run.poll();
          Polling poll(run);  // a layer of a thin body's box may hold millions of places
          lattice.for_each_in(cubes, layer, boxes[b], [&](const Vec3& p) {
            poll();
            const auto holds = [&](const Box& box) { return box.contains(p); };
            if (!holds(boxes[b]) ||
                std::any_of(boxes.begin(), boxes.begin() + static_cast<long>(b), holds))
              return;
            if (inside(p)) in_layer.push_back(p);
          });
        });
    nodes.insert(nodes.end(), found.begin(), found.end());
  }
  return nodes;
}

/// Leaves out the nodes that are too many, evenly along the order of the lattice.
void reduce_to(std::vector<Vec3>& nodes, std::size_t count) {
  if (nodes.size() <= count) return;
  const std::size_t all = nodes.size();
  for (std::size_t k = 0; k < count; ++k) nodes[k] = nodes[k * all / count];
  nodes.resize(count);
}

}  // namespace

std::vector<Vec3> fill_lattice(const std::vector<Box>& boxes, const InsideTest& inside,
                               const FillOptions& options, const Run& run) {
  // Two nodes to a cube of the lattice.
  if (!options.count)
    return nodes_inside(Lattice(std::cbrt(2 / options.density), options.seed), boxes, inside, run);
  if (*options.count == 0) return {};
  const double count = *options.count;
  double constant = options.edge_length;
  std::vector<Vec3> nodes;
  for (int k = 0; k < kLatticeFilling.tries; ++k) {
    nodes = nodes_inside(Lattice(constant, options.seed), boxes, inside, run);
    const auto found = static_cast<double>(nodes.size());
    if (found >= count && found <= kLatticeFilling.surplus * count) break;
    if (found == 0 && k >= kLatticeFilling.empty_tries) break;
    constant *= found > 0 ? std::cbrt(found / (0.5 * (1 + kLatticeFilling.surplus) * count)) : 0.5;
  }
  reduce_to(nodes, *options.count);
  return nodes;
}

}  // namespace remeshd
