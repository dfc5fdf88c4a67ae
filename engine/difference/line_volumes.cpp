#include "engine/difference/line_volumes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "engine/base/random.h"
#include "engine/difference/line_crossings.h"

namespace remeshd {
namespace {

constexpr int kReplicates = 16;
constexpr double kStandardErrors = 5;

/// A model at whose surfaces the class may change along a line; `where` takes the line into the
/// model's coordinates.
struct Obstacles {
  const Membership* model;
  Transform where;
};

struct Estimate {
  ClassTotals volumes, errors;
};

/// Parallel lines that cover a box: a direction, and a rectangle across it.
class Sheaf {
 public:
  Sheaf(const Box& box, const Vec3& direction)
      : direction_(direction), e_(any_perpendicular(direction)), f_(cross(direction, e_)) {
    Box across;
    for (const Vec3& corner : corners_of(box))
      across.add(Vec3{dot(corner, e_), dot(corner, f_), dot(corner, direction)});
    lo_ = across.lo;
    size_ = across.hi - across.lo;
  }

  [[nodiscard]] Line line(double u, double v) const {
    return {(lo_.x + u * size_.x) * e_ + (lo_.y + v * size_.y) * f_, direction_, lo_.z,
            lo_.z + size_.z};
  }
  [[nodiscard]] double area() const { return size_.x * size_.y; }

 private:
  Vec3 direction_, e_, f_;
  Vec3 lo_, size_;
};

/// A body diagonal of a cube, turned at random so that no face of a usual model is parallel to it:
/// then the length inside a body changes continuously from line to line, and a lattice of lines is
/// exact to second order.
Vec3 direction(int replicate, Random& random) {
  const auto component = [&](bool negative) {
    const double size = random.uniform(0.7, 1.3);
    return negative ? -size : size;
  };
  const double x = component(replicate & 1), y = component(replicate & 2);
  return normalised({x, y, random.uniform(0.7, 1.3)});
}

/// The first Fibonacci number, from 2 on, that is not less than `wanted`, and the one before it.
std::array<int, 2> fibonacci(int wanted) {
  std::array<int, 2> f{2, 1};
  while (f[0] < wanted) f = {f[0] + f[1], f[0]};
  return f;
}

/// Estimates the volume of each class within a box; `class_at` tells the class at a point.
Estimate along_lines(const Box& box, const std::vector<Obstacles>& obstacles,
                     const std::function<DifferenceClass(const Vec3&)>& class_at,
                     const LineOptions& options, const Run& run) {
  const auto [n, step] = fibonacci(options.lines / kReplicates);
  Random random(options.seed);
  std::vector<double> stops;
  std::array<ClassTotals, kReplicates> volumes;
  for (int r = 0; r < kReplicates; ++r) {
    const Sheaf sheaf(box, direction(r, random));
    const double u = random.uniform(), v = random.uniform();
    for (int i = 0; i < n; ++i) {
      if (i % 256 == 0) run.poll();
      double whole = 0;
      Line line = sheaf.line(std::modf(u + static_cast<double>(i) / n, &whole),
                             std::modf(v + static_cast<double>(i) * step / n, &whole));
      if (!clip(line, box)) continue;
      stops = {line.begin, line.end};
      for (const Obstacles& at : obstacles) {
        const Line there{at.where.apply(line.p), at.where.rotate(line.direction), line.begin,
                         line.end};
        for (const Solid& solid : at.model->solids())
          if (Line within = there; clip(within, solid.bounds()))
            for (const SolidFace& face : solid.faces())
              append_crossings(face.surface, there, stops);
      }
      std::sort(stops.begin(), stops.end());
      for (std::size_t k = 0; k + 1 < stops.size(); ++k)
        if (const double length = stops[k + 1] - stops[k]; length > 0)
          volumes[r][class_at(line.p + 0.5 * (stops[k] + stops[k + 1]) * line.direction)] +=
              sheaf.area() * length / n;
    }
  }
  Estimate out;
  for (const DifferenceClass c : kAllClasses) {
    double mean = 0, squares = 0;
    for (const ClassTotals& volume : volumes) mean += volume[c] / kReplicates;
    for (const ClassTotals& volume : volumes) squares += (volume[c] - mean) * (volume[c] - mean);
    out.volumes[c] = mean;
    out.errors[c] = kStandardErrors * std::sqrt(squares / (kReplicates * (kReplicates - 1)));
  }
  return out;
}

/// Replaces the estimates of all classes but the persistent-identical ones by sums over boxes that
/// do not overlap.
void measure_changes(Estimate& out, const std::vector<Box>& boxes,
                     const std::vector<Obstacles>& obstacles,
                     const std::function<DifferenceClass(const Vec3&)>& class_at,
                     LineOptions options, const Run& run) {
  using enum DifferenceClass;
  for (const DifferenceClass c : kAllClasses)
    if (c != IdenticalYes && c != IdenticalNo) out.volumes[c] = out.errors[c] = 0;
  options.lines = std::max(1024, options.lines / std::max(1, static_cast<int>(boxes.size())));
  for (const Box& box : boxes) {
    ++options.seed;  // else the errors of equal boxes add up
    const Estimate part = along_lines(box, obstacles, class_at, options, run);
    for (const DifferenceClass c : {ToNo, ToYes, NewYes, NewNo, OldYes, OldNo}) {
      out.volumes[c] += part.volumes[c];
      out.errors[c] += part.errors[c];
    }
  }
}

}  // namespace

VolumeEstimate estimate_volumes(const PointClasses& classes, const LineOptions& options,
                                const Run& run) {
  VolumeEstimate out;
  const auto& pairs = classes.features();
  for (int f = 0; f < static_cast<int>(pairs.size()); ++f) {
    const FeaturePair& pair = pairs[f];
    Box box;
    std::vector<Obstacles> obstacles;
    if (pair.modified >= 0) {
      box.add(classes.modified().solids()[pair.modified].bounds());
      obstacles.push_back({&classes.modified(), {}});
    }
    if (pair.original >= 0) {
      box.add(moved(classes.original().solids()[pair.original].bounds(),
                    rigid_inverse(pair.to_original)));
      obstacles.push_back({&classes.original(), pair.to_original});
    }
    const auto class_at = [&](const Vec3& p) { return classes.cell(f, p); };
    Estimate estimate = along_lines(box, obstacles, class_at, options, run);
    measure_changes(estimate, classes.changed(f), obstacles, class_at, options, run);
    out.features.push_back(estimate.volumes);
    out.feature_errors.push_back(estimate.errors);
  }

  std::vector<Obstacles> obstacles{{&classes.modified(), {}}};
  for (const FeaturePair& pair : pairs)
    if (pair.original >= 0 && pair.modified >= 0 &&
        std::none_of(obstacles.begin() + 1, obstacles.end(),
                     [&](const Obstacles& at) { return at.where == pair.to_original; }))
      obstacles.push_back({&classes.original(), pair.to_original});
  const auto class_at = [&](const Vec3& p) {
    if (classes.in_copycell(p)) return DifferenceClass::IdenticalYes;
    return classes.in_newcell(p) ? DifferenceClass::NewYes : DifferenceClass::Artefact;
  };
  Estimate estimate = along_lines(classes.modified().bounds(), obstacles, class_at, options, run);
  measure_changes(estimate, classes.changed(), obstacles, class_at, options, run);
  out.copycells = estimate.volumes[DifferenceClass::IdenticalYes];
  out.copycells_error = estimate.errors[DifferenceClass::IdenticalYes];
  out.newcells = estimate.volumes[DifferenceClass::NewYes];
  out.newcells_error = estimate.errors[DifferenceClass::NewYes];
  return out;
}

}  // namespace remeshd
