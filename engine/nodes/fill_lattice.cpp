#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/base/random.h"
#include "engine/nodes/fill.h"

namespace remeshd {

namespace {

struct LatticeFilling {
  /// Share of the lattice constant by which a node may be off its place along each axis. From .02
  /// to .1 the meshes are equally good; without it cospherical nodes leave worse ones.
  double jitter = 0.05;
  /// The lattice of a count may hold so many times more nodes, which are then left out evenly.
  double surplus = 1.004;
  int tries = 12;       ///< to find the lattice constant for a count
  int empty_tries = 3;  ///< of these with no node at all, each at half the constant
};
constexpr LatticeFilling kFill;
constexpr double kShaken = 2;  // x jitter: no node is further from its place than sqrt(3) of it

/// One lattice through all of space.
class Lattice {
 public:
  Lattice(double constant, std::uint64_t seed) : a_(constant), seed_(seed) {
    Random random(seed);
    offset_ = a_ * Vec3{random.uniform(), random.uniform(), random.uniform()};
    // Turned by .5 rad about z, then by .7 rad about the new x axis.
    const double c = std::cos(0.5), s = std::sin(0.5), d = std::cos(0.7), e = std::sin(0.7);
    axes_ = {Vec3{c, s, 0}, Vec3{-s * d, c * d, e}, Vec3{s * e, -c * e, d}};
  }

  /// Cubes of the lattice from `lo` to `hi` along each of its axes.
  struct Cubes {
    std::array<long, 3> lo{}, hi{};

    [[nodiscard]] std::size_t layers() const { return hi[2] - lo[2] + 1; }
  };
  /// All that touch a box.
  [[nodiscard]] Cubes cubes_of(const Box& box) const {
    Cubes cubes;
    for (int i = 0; i < 3; ++i) {
      double least = HUGE_VAL, most = -HUGE_VAL;
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p{corner & 1 ? box.lo.x : box.hi.x, corner & 2 ? box.lo.y : box.hi.y,
                     corner & 4 ? box.lo.z : box.hi.z};
        const double along = dot(p - offset_, axes_[i]) / a_;
        least = std::fmin(least, along);
        most = std::fmax(most, along);
      }
      cubes.lo[i] = static_cast<long>(std::floor(least)) - 1;
      cubes.hi[i] = static_cast<long>(std::ceil(most)) + 1;
    }
    return cubes;
  }

  /// Calls `visit(p)` for the nodes in a layer of cubes that may be in the box, in the order of the
  /// lattice.
  template <class Visit>
  void for_each_in(const Cubes& cubes, std::size_t layer, const Box& box,
                   const Visit& visit) const {
    const double shaken = kShaken * kFill.jitter * a_;
    const long z = cubes.lo[2] + static_cast<long>(layer);
    for (long y = cubes.lo[1]; y <= cubes.hi[1]; ++y)
      for (long x = cubes.lo[0]; x <= cubes.hi[0]; ++x)
        for (const int centre : {0, 1}) {
          const auto along = [&](long v) { return static_cast<double>(v) + 0.5 * centre; };
          if (box.contains(place(along(x), along(y), along(z)), shaken))
            visit(node(x, y, z, centre));
        }
  }

 private:
  [[nodiscard]] Vec3 place(double u, double v, double w) const {
    return offset_ + a_ * (u * axes_[0] + v * axes_[1] + w * axes_[2]);
  }
  /// The shaking depends on the place in the lattice alone: overlapping boxes see the same node.
  [[nodiscard]] Vec3 node(long x, long y, long z, int centre) const {
    const auto mix = [](long v, std::uint64_t factor) {
      return static_cast<std::uint64_t>(v) * factor;
    };
    Random random(seed_ ^ (mix(2 * x + centre, 0x9E3779B97F4A7C15ULL) +
                           mix(y, 0xC2B2AE3D27D4EB4FULL) + mix(z, 0x165667B19E3779F9ULL)));
    const auto along = [&](long v) {
      return static_cast<double>(v) + 0.5 * centre + random.uniform(-kFill.jitter, kFill.jitter);
    };
    const double u = along(x), v = along(y), w = along(z);
    return place(u, v, w);
  }

  double a_;
  std::uint64_t seed_;
  Vec3 offset_;
  std::array<Vec3, 3> axes_;
};

std::vector<Vec3> nodes_inside(const Lattice& lattice, const std::vector<Box>& boxes,
                               const InsideTest& inside, const Run& run) {
  std::vector<Vec3> nodes;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    if (boxes[b].empty()) continue;
    const Lattice::Cubes cubes = lattice.cubes_of(boxes[b]);
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
void decimate_close_nodes(std::vector<Vec3>& nodes, std::size_t count) {
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
  const double count = *options.count;
  double constant = options.edge_length;
  std::vector<Vec3> nodes;
  for (int k = 0; k < kFill.tries; ++k) {
    nodes = nodes_inside(Lattice(constant, options.seed), boxes, inside, run);
    const auto found = static_cast<double>(nodes.size());
    if (found >= count && found <= kFill.surplus * count) break;
    if (found == 0 && k >= kFill.empty_tries) break;
    constant *= found > 0 ? std::cbrt(found / (0.5 * (1 + kFill.surplus) * count)) : 0.5;
  }
  decimate_close_nodes(nodes, *options.count);
  return nodes;
}

}  // namespace remeshd
