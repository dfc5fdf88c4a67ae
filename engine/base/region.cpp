#include "engine/base/region.h"

#include <algorithm>
#include <cmath>

namespace remeshd {

namespace {
constexpr double kMostCubes = 1e7;  // bound on memory
}

Region::Region(std::span<const Vec3> points, double reach, int steps) : width_(reach / steps) {
  for (const Vec3& p : points) box_.add(p);
  if (points.empty()) return;
  const Vec3 extent = box_.hi - box_.lo;
  const auto cubes = [&] {
    const double around = 2 * steps + 1;
    return (extent.x / width_ + around) * (extent.y / width_ + around) *
           (extent.z / width_ + around);
  };
  while (cubes() > kMostCubes) width_ *= 1.3;
  const double around = steps * width_;
  box_.lo -= Vec3{around, around, around};
  const auto count = [&](double length) {
    return static_cast<int>(std::floor((length + around) / width_)) + 1 + steps;
  };
  size_ = {count(extent.x), count(extent.y), count(extent.z)};
  box_.hi = box_.lo + width_ * Vec3{static_cast<double>(size_[0]), static_cast<double>(size_[1]),
                                    static_cast<double>(size_[2])};
  holds_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2], 0);
  for (const Vec3& p : points) {
    const auto c = cube_of(p);
    holds_[index(c[0], c[1], c[2])] = 1;
  }
  widen(steps);
}

/// Adds all cubes up to `steps` away along each axis, one axis after the other.
void Region::widen(int steps) {
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(size_[0]),
                                          static_cast<std::size_t>(size_[0]) * size_[1]};
  std::vector<std::uint8_t> line;
  for (int axis = 0; axis < 3; ++axis) {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    for (int j = 0; j < size_[b]; ++j)
      for (int k = 0; k < size_[c]; ++k) {
        const std::size_t begin = j * stride[b] + k * stride[c];
        line.assign(size_[axis], 0);
        int until = -1;  // last index within `steps` of a cube met so far
        for (int i = -steps; i < size_[axis]; ++i) {
          const int ahead = i + steps;
          if (ahead < size_[axis] && holds_[begin + ahead * stride[axis]]) until = ahead + steps;
          if (i >= 0 && i <= until) line[i] = 1;
        }
        for (int i = 0; i < size_[axis]; ++i) holds_[begin + i * stride[axis]] = line[i];
      }
  }
}

std::array<int, 3> Region::cube_of(const Vec3& p) const {
  const auto axis = [&](double v, double lo, int n) {
    return std::clamp(static_cast<int>((v - lo) / width_), 0, n - 1);
  };
  return {axis(p.x, box_.lo.x, size_[0]), axis(p.y, box_.lo.y, size_[1]),
          axis(p.z, box_.lo.z, size_[2])};
}

bool Region::meets(const Box& box) const {
  if (holds_.empty() || intersection(box, box_).empty()) return false;
  const std::array<int, 3> low = cube_of(box.lo), high = cube_of(box.hi);
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x)
        if (holds_[index(x, y, z)] != 0) return true;
  return false;
}

std::vector<Box> Region::boxes() const {
  std::vector<Box> boxes;
  std::vector<std::uint8_t> left = holds_;
  std::vector<std::array<int, 3>> queue;
  for (int z = 0; z < size_[2]; ++z)
    for (int y = 0; y < size_[1]; ++y)
      for (int x = 0; x < size_[0]; ++x) {
        if (!left[index(x, y, z)]) continue;
        Box box;
        left[index(x, y, z)] = 0;
        queue.assign(1, {x, y, z});
        while (!queue.empty()) {
          const std::array<int, 3> c = queue.back();
          queue.pop_back();
          const Vec3 corner =
              box_.lo + width_ * Vec3{static_cast<double>(c[0]), static_cast<double>(c[1]),
                                      static_cast<double>(c[2])};
          box.add(corner);
          box.add(corner + Vec3{width_, width_, width_});
          for (int axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
              std::array<int, 3> next = c;
              next[axis] += step;
              if (next[axis] < 0 || next[axis] >= size_[axis]) continue;
              std::uint8_t& there = left[index(next[0], next[1], next[2])];
              if (!there) continue;
              there = 0;
              queue.push_back(next);
            }
        }
        boxes.push_back(box);
      }
  return boxes;
}

}  // namespace remeshd
