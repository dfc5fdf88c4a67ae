#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

namespace remeshd {

/// A point or direction; lengths in the model's unit.
struct Vec3 {
  double x = 0, y = 0, z = 0;

  friend bool operator==(const Vec3&, const Vec3&) = default;
};

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vec3 operator*(const Vec3& a, double s) { return s * a; }
inline Vec3 operator/(const Vec3& a, double s) { return {a.x / s, a.y / s, a.z / s}; }
inline Vec3& operator+=(Vec3& a, const Vec3& b) { return a = a + b; }
inline Vec3& operator-=(Vec3& a, const Vec3& b) { return a = a - b; }
inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm2(const Vec3& a) { return dot(a, a); }
inline double norm(const Vec3& a) { return std::sqrt(norm2(a)); }
inline double distance(const Vec3& a, const Vec3& b) { return norm(a - b); }
inline Vec3 normalised(const Vec3& a) { return a / norm(a); }

inline double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * norm(cross(b - a, c - a));
}

/// Lexicographic order by x, y, z.
inline bool lies_before(const Vec3& a, const Vec3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// Some unit vector at right angles to the unit vector `n`; the same for the same `n`.
inline Vec3 any_perpendicular(const Vec3& n) {
  const Vec3 a = std::fabs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return normalised(a - dot(a, n) * n);
}

/// Axis-aligned box; empty until the first point is added.
struct Box {
  Vec3 lo{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vec3 hi{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Vec3& p) {
    // A NaN leaves the bounds as they are.
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
  }
  void add(const Box& b) {
    add(b.lo);
    add(b.hi);
  }
  [[nodiscard]] bool contains(const Vec3& p, double margin = 0) const {
    return p.x >= lo.x - margin && p.x <= hi.x + margin && p.y >= lo.y - margin &&
           p.y <= hi.y + margin && p.z >= lo.z - margin && p.z <= hi.z + margin;
  }
  [[nodiscard]] bool empty() const { return lo.x > hi.x || lo.y > hi.y || lo.z > hi.z; }
  [[nodiscard]] double diagonal() const { return empty() ? 0 : distance(lo, hi); }
};

inline Box intersection(const Box& a, const Box& b) {
  return {{std::max(a.lo.x, b.lo.x), std::max(a.lo.y, b.lo.y), std::max(a.lo.z, b.lo.z)},
          {std::min(a.hi.x, b.hi.x), std::min(a.hi.y, b.hi.y), std::min(a.hi.z, b.hi.z)}};
}

inline Box box_of(std::span<const Vec3> points) {
  Box box;
  for (const Vec3& p : points) box.add(p);
  return box;
}
/// The box round those of the points that have these numbers.
template <class Points, class Numbers>
Box box_of(const Points& points, const Numbers& numbers) {
  Box box;
  for (const auto n : numbers) box.add(points[n]);
  return box;
}

/// Whether the boxes have a point in common, boundaries included.
inline bool touch(const Box& a, const Box& b) {
  return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y &&
         a.lo.z <= b.hi.z && b.lo.z <= a.hi.z;
}

inline std::array<Vec3, 8> corners_of(const Box& box) {
  std::array<Vec3, 8> c;
  for (int i = 0; i < 8; ++i)
    c[i] = {i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z};
  return c;
}

/// The box, larger by `by` on all sides.
inline Box grown(const Box& box, double by) {
  const Vec3 margin{by, by, by};
  return {box.lo - margin, box.hi + margin};
}

/// An affine map kept as the three rows of a 3x4 matrix [R | t].
///
/// `apply` works row by row, each row from left to right, with no fused operation, so that any
/// client that multiplies out the same matrix in IEEE doubles gets the same bits. The identity
/// copies bits.
struct Transform {
  std::array<double, 12> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  friend bool operator==(const Transform&, const Transform&) = default;
  [[nodiscard]] bool is_identity() const { return *this == Transform{}; }

  [[nodiscard]] Vec3 apply(const Vec3& p) const {
    if (is_identity()) return p;
    return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
            m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
            m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
  }
  /// The linear part alone.
  [[nodiscard]] Vec3 rotate(const Vec3& v) const {
    return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[4] * v.x + m[5] * v.y + m[6] * v.z,
            m[8] * v.x + m[9] * v.y + m[10] * v.z};
  }
  /// Frame with the given right-handed orthonormal axes as columns.
  static Transform frame(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& origin) {
    return {{x.x, y.x, z.x, origin.x, x.y, y.y, z.y, origin.y, x.z, y.z, z.z, origin.z}};
  }
  static Transform translation(const Vec3& t) {
    return {{1, 0, 0, t.x, 0, 1, 0, t.y, 0, 0, 1, t.z}};
  }
};

/// `a` after `b`: (a * b).apply(p) is a.apply(b.apply(p)) up to rounding.
inline Transform operator*(const Transform& a, const Transform& b) {
  Transform c;
  for (int r = 0; r < 3; ++r) {
    for (int k = 0; k < 4; ++k) {
      double s = k == 3 ? a.m[4 * r + 3] : 0.0;
      for (int j = 0; j < 3; ++j) s += a.m[4 * r + j] * b.m[4 * j + k];
      c.m[4 * r + k] = s;
    }
  }
  return c;
}

/// The axis-aligned box round a moved box.
inline Box moved(const Box& box, const Transform& motion) {
  Box out;
  for (const Vec3& corner : corners_of(box)) out.add(motion.apply(corner));
  return out;
}

/// Inverse of a rigid transformation.
inline Transform rigid_inverse(const Transform& a) {
  Transform c;
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < 3; ++k) c.m[4 * r + k] = a.m[4 * k + r];
  const Vec3 t = c.rotate({a.m[3], a.m[7], a.m[11]});
  c.m[3] = -t.x;
  c.m[7] = -t.y;
  c.m[11] = -t.z;
  return c;
}

}  // namespace remeshd
