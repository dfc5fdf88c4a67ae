#include "engine/second_order/jacobian.h"

#include <algorithm>

namespace remeshd {

namespace {

double determinant(const Vec3& a, const Vec3& b, const Vec3& c) { return dot(cross(a, b), c); }

/// The node between two corners.
constexpr std::array<std::array<int, 4>, 4> kMidOf{
    {{-1, 0, 2, 3}, {0, -1, 1, 4}, {2, 1, -1, 5}, {3, 4, 5, -1}}};

/// Derivative by the barycentric coordinate of one corner, at another.
Vec3 derivative(const QuadraticTet& tet, int by, int at) {
  if (by == at) return 3 * tet.corners[by];
  return 4 * tet.mids[kMidOf[by][at]] - tet.corners[by];
}

}  // namespace

double least_jacobian(const QuadraticTet& tet) {
  // The columns of the Jacobian are linear: what they are at the corners tells all of them.
  std::array<std::array<Vec3, 4>, 3> columns;
  for (int at = 0; at < 4; ++at) {
    const Vec3 first = derivative(tet, 0, at);
    for (int k = 0; k < 3; ++k) columns[k][at] = derivative(tet, k + 1, at) - first;
  }
  const auto product = [&](int p, int q, int r) {
    return determinant(columns[0][p], columns[1][q], columns[2][r]);
  };
  // The coefficient of three corners is the mean of the products in which they come in any order.
  double least = product(0, 0, 0);
  for (int p = 0; p < 4; ++p)
    for (int q = p; q < 4; ++q)
      for (int r = q; r < 4; ++r)
        least = std::min(least, (product(p, q, r) + product(p, r, q) + product(q, p, r) +
                                 product(q, r, p) + product(r, p, q) + product(r, q, p)) /
                                    6);
  const auto& [a, b, c, d] = tet.corners;
  return least / determinant(b - a, c - a, d - a);
}

}  // namespace remeshd
