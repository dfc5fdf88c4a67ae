#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/base/random.h"
#include "engine/nodes/fill/fill.h"
#include "engine/nodes/fill/turned_lattice.h"
#include "engine/nodes/nearest.h"

namespace remeshd {

namespace {

struct GradedFilling {
  /// Constant of the body-centred cubic lattice with sqrt(2) nodes per cube of an edge length.
  double constant = 1.122462048309373;
  /// A cube is divided where it is so many times larger than that of the local edge length. What
  /// is not divided, and so not thinned out, makes the best tets; but an even stretch of the field
  /// between two levels gets edges that are longer by this.
  double largest = 1.2;
  double largest_asked = 1;  ///< the same where the model asks for that length, below the roots
  double jitter = 0.05;      ///< x side of the cube: of a node from its place, along each axis
  double closest = 0.72;     ///< x local edge length: no node is nearer to another
  /// The same where the model asks for that length. Nodes that are put one after another, none
  /// nearer than d to one before, come to .73 / d^3 per volume; sqrt(2) are wanted.
  double closest_asked = 0.8;
  int deepest = 12;     ///< levels below the lattice's cubes, at most
  double most = 4;      ///< x limit on nodes: more places for nodes are refused
  double places = 4.5;  ///< listed per node: 9 by each cube, which has 2 of its own
};
constexpr GradedFilling kGradedFilling;

/// A place for a node: the corner or the centre of a cube of an octree.
struct Place {
  std::array<long, 3> at;  ///< in halves of the smallest cubes
  int level;               ///< of a cube whose corner or centre it is
};

/// Takes out duplicates of places; the one of the smallest cube is left.
void leave_once(std::vector<Place>& places) {
  std::ranges::sort(places, [](const Place& a, const Place& b) {
    return std::tie(a.at, b.level) < std::tie(b.at, a.level);
  });
  const auto twice = std::ranges::unique(places, {}, &Place::at);
  places.erase(twice.begin(), twice.end());
}

/// How many nodes would be left of so many places is not known.
Error too_large(const Run& run) {
  return error::mesh_too_large("the edge lengths asked for need over", run.max_nodes, run.max_nodes,
                               {}, {}, "ask for longer edges or for a larger least one");
}

/// Octrees over the cubes of a lattice, divided where the field is finer.
class Octrees {
 public:
  Octrees(const SizeField& sizes, std::uint64_t seed, const Run& run)
      : sizes_(sizes),
        seed_(seed),
        run_(run),
        most_places_(
            static_cast<std::size_t>(kGradedFilling.places * kGradedFilling.most * run.max_nodes)),
        lattice_(kGradedFilling.constant * sizes.base(), seed),
        levels_(std::clamp(static_cast<int>(std::ceil(std::log2(sizes.base() / sizes.least()))), 0,
                           kGradedFilling.deepest)) {}

  [[nodiscard]] const TurnedLattice& lattice() const { return lattice_; }
  /// Adds the corners and centres of the cubes in a layer that may be in the box.
  void add_layer(const TurnedLattice::Cubes& cubes, std::size_t layer, const Box& box,
                 Polling& poll, std::vector<Place>& places) const {
    const long z = cubes.lo[2] + static_cast<long>(layer);
    for (long y = cubes.lo[1]; y <= cubes.hi[1]; ++y)
      for (long x = cubes.lo[0]; x <= cubes.hi[0]; ++x) divide({x, y, z}, 0, box, poll, places);
  }
  /// The position of the node for a place: jittered.
  [[nodiscard]] Vec3 position(const Place& place) const {
    Random random = TurnedLattice::draw(place.at, seed_);
    const double unit = 1.0 / static_cast<double>(2L << levels_);
    const double most = kGradedFilling.jitter / static_cast<double>(1L << place.level);
    const auto along = [&](int axis) {
      return unit * static_cast<double>(place.at[axis]) + random.uniform(-most, most);
    };
    const double u = along(0), v = along(1), w = along(2);
    return lattice_.place(u, v, w);
  }

 private:
  void divide(const std::array<long, 3>& cube, int level, const Box& box, Polling& poll,
              std::vector<Place>& places) const {
    poll();
    const double width = 1.0 / static_cast<double>(1L << level);
    const auto along = [&](int axis) { return (static_cast<double>(cube[axis]) + 0.5) * width; };
    const Vec3 middle = lattice_.place(along(0), along(1), along(2));
    const double constant = width * lattice_.constant();
    if (!box.contains(middle, constant)) return;
    if (level < levels_ && is_too_large(constant, level, middle)) {
      for (int octant = 0; octant < 8; ++octant)
        divide({2 * cube[0] + (octant & 1), 2 * cube[1] + (octant >> 1 & 1),
                2 * cube[2] + (octant >> 2)},
               level + 1, box, poll, places);
      return;
    }
    if (places.size() > most_places_) throw too_large(run_);
    const long half = 1L << (levels_ - level);  // of the cube
    const std::array<long, 3> low{2 * half * cube[0], 2 * half * cube[1], 2 * half * cube[2]};
    places.push_back({{low[0] + half, low[1] + half, low[2] + half}, level});
    for (int corner = 0; corner < 8; ++corner)
      places.push_back({{low[0] + 2 * half * (corner & 1), low[1] + 2 * half * (corner >> 1 & 1),
                         low[2] + 2 * half * (corner >> 2)},
                        level});
  }

  [[nodiscard]] bool is_too_large(double constant, int level, const Vec3& middle) const {
    const double length = constant / kGradedFilling.constant;
    return sizes_.is_below(middle, length / kGradedFilling.largest) ||
           (level > 0 && sizes_.is_asked_below(middle, length / kGradedFilling.largest_asked));
  }

  const SizeField& sizes_;
  std::uint64_t seed_;
  const Run& run_;
  std::size_t most_places_;
  TurnedLattice lattice_;
  int levels_;
};

/// The places in the boxes where `inside` holds, each once, those of small cubes first.
std::vector<Place> places_in(const Octrees& octrees, const std::vector<Box>& boxes,
                             const InsideTest& inside, const Run& run) {
  std::vector<Place> places;
  for (const Box& box : boxes) {
    if (box.empty()) continue;
    const TurnedLattice::Cubes cubes = octrees.lattice().cubes_of(box);
    const auto found = collect_in_blocks<Place>(
        cubes.layers(), 1, run, [&](std::size_t layer, std::size_t, std::vector<Place>& in_layer) {
          run.poll();
          Polling poll(run);  // a layer of a thin body's box may hold millions of places
          std::vector<Place> all;
          octrees.add_layer(cubes, layer, box, poll, all);
          leave_once(all);
          for (const Place& place : all) {
            poll();
            const Vec3 p = octrees.position(place);
            if (box.contains(p) && inside(p)) in_layer.push_back(place);
          }
        });
    places.insert(places.end(), found.begin(), found.end());
    if (static_cast<double>(places.size()) > kGradedFilling.most * run.max_nodes)
      throw too_large(run);
  }
  leave_once(places);
  std::ranges::stable_sort(places, std::ranges::greater(), &Place::level);
  return places;
}

/// Whether a node at p may stay so far from the nearest one before.
bool is_far_enough(double distance, const Vec3& p, const SizeField& sizes) {
  if (!sizes.is_below(p, distance / kGradedFilling.closest)) return false;
  return !sizes.has_asked() || sizes.is_below(p, distance / kGradedFilling.closest_asked) ||
         !sizes.is_asked_below(p, sizes.base());
}

/// Leaves out nodes that are nearer to an earlier one than the field allows.
void thin_out(std::vector<Vec3>& nodes, const SizeField& sizes, const Run& run) {
  const NearestNode grid(nodes, kGridCell * sizes.grid_length());
  std::vector<std::uint8_t> stays(nodes.size(), 0);
  Polling poll(run);
  const double reach = sizes.has_asked() ? kGradedFilling.closest_asked : kGradedFilling.closest;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    poll();
    double nearest2 = HUGE_VAL;  // of nodes that may be too near
    grid.for_each_within(nodes[n], reach * sizes.bound(nodes[n]),
                         [&](std::int32_t other, double d2) {
                           if (stays[other] != 0) nearest2 = std::fmin(nearest2, d2);
                         });
    stays[n] = nearest2 == HUGE_VAL || is_far_enough(std::sqrt(nearest2), nodes[n], sizes) ? 1 : 0;
  }
  std::size_t left = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (stays[n] != 0) nodes[left++] = nodes[n];
  nodes.resize(left);
}

}  // namespace

std::vector<Vec3> fill_graded(const std::vector<Box>& boxes, const InsideTest& inside,
                              const SizeField& sizes, std::uint64_t seed, const Run& run) {
  const Octrees octrees(sizes, seed, run);
  std::vector<Vec3> nodes;
  for (const Place& place : places_in(octrees, boxes, inside, run))
    nodes.push_back(octrees.position(place));
  thin_out(nodes, sizes, run);
  return nodes;
}

}  // namespace remeshd
