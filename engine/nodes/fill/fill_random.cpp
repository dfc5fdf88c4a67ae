#include <algorithm>
#include <cmath>

#include "engine/base/random.h"
#include "engine/nodes/fill/fill.h"

namespace remeshd {

namespace {

constexpr double kCellShare =
    0.5;                   // of the edge length: finer than the layers that have to be filled
constexpr int kTries = 8;  // to hit the inside of a cell that the region cuts

/// Centres of the grid cells inside, in serpentine order; a cell covered by several boxes counts
/// once.
std::vector<Vec3> cells_inside(const std::vector<Box>& boxes, double h, const InsideTest& inside,
                               const Run& run) {
  std::vector<Vec3> centres;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    if (boxes[b].empty()) continue;
    // One grid for all boxes, so that overlapping boxes share their cells.
    const auto first = [h](double v) { return static_cast<long>(std::floor(v / h)); };
    const long x0 = first(boxes[b].lo.x), x1 = first(boxes[b].hi.x);
    const long y0 = first(boxes[b].lo.y), y1 = first(boxes[b].hi.y);
    const long z0 = first(boxes[b].lo.z), z1 = first(boxes[b].hi.z);
    bool y_up = true, x_up = true;
    Polling poll(run);
    for (long z = z0; z <= z1; ++z) {
      for (long j = 0; j <= y1 - y0; ++j) {
        const long y = y_up ? y0 + j : y1 - j;
        for (long i = 0; i <= x1 - x0; ++i) {
          const long x = x_up ? x0 + i : x1 - i;
          poll();
          const Vec3 c{(x + 0.5) * h, (y + 0.5) * h, (z + 0.5) * h};
          const auto seen_in = [&](const Box& box) {
            return x >= first(box.lo.x) && x <= first(box.hi.x) && y >= first(box.lo.y) &&
                   y <= first(box.hi.y) && z >= first(box.lo.z) && z <= first(box.hi.z);
          };
          if (std::any_of(boxes.begin(), boxes.begin() + static_cast<long>(b), seen_in)) continue;
          if (inside(c)) centres.push_back(c);
        }
        x_up = !x_up;
      }
      y_up = !y_up;
    }
  }
  return centres;
}

}  // namespace

std::vector<Vec3> fill_random(const std::vector<Box>& boxes, const InsideTest& inside,
                              const FillOptions& options, const Run& run) {
  double h = kCellShare * options.edge_length;
  std::vector<Vec3> centres = cells_inside(boxes, h, inside, run);
  // A whole model so thin that no centre lies in it still deserves nodes; a newcell does not.
  for (int k = 0; k < 3 && centres.empty() && options.count; ++k)
    centres = cells_inside(boxes, h *= 0.5, inside, run);
  std::vector<Vec3> nodes;
  if (centres.empty()) return nodes;
  const double share = options.count ? *options.count / static_cast<double>(centres.size())
                                     : options.density * h * h * h;
  Random random(options.seed);
  double owed = options.count ? 0.5 : random.uniform();
  for (const Vec3& c : centres) {
    owed += share;
    for (; owed >= 1; owed -= 1) {
      Vec3 p = c;
      for (int k = 0; k < kTries; ++k) {
        const Vec3 q = c + h * Vec3{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5),
                                    random.uniform(-0.5, 0.5)};
        if (inside(q)) {
          p = q;
          break;
        }
      }
      nodes.push_back(p);
    }
  }
  return nodes;
}

}  // namespace remeshd
