#include "engine/base/hilbert.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/random.h"

namespace remeshd {

namespace {
constexpr int kBits = 16;

std::uint32_t quantise(double v, double lo, double hi) {
  const double t = hi > lo ? (v - lo) / (hi - lo) : 0.0;
  return static_cast<std::uint32_t>(std::clamp(t, 0.0, 1.0) * ((1 << kBits) - 1));
}
}  // namespace

std::uint64_t hilbert_key(const Vec3& p, const Box& box) {
  std::array<std::uint32_t, 3> x{quantise(p.x, box.lo.x, box.hi.x),
                                 quantise(p.y, box.lo.y, box.hi.y),
                                 quantise(p.z, box.lo.z, box.hi.z)};
  for (std::uint32_t q = 1U << (kBits - 1); q > 1; q >>= 1) {
    const std::uint32_t below = q - 1;
    for (int i = 0; i < 3; ++i) {
      if (x[i] & q) {
        x[0] ^= below;
      } else {
        const std::uint32_t t = (x[0] ^ x[i]) & below;
        x[0] ^= t;
        x[i] ^= t;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t t = 0;
  for (std::uint32_t q = 1U << (kBits - 1); q > 1; q >>= 1)
    if (x[2] & q) t ^= q - 1;
  std::uint64_t key = 0;
  for (auto& v : x) v ^= t;
  for (int bit = kBits - 1; bit >= 0; --bit)
    for (const auto v : x) key = (key << 1) | ((v >> bit) & 1U);
  return key;
}

std::vector<Vec3> along_hilbert_curve(std::span<const Vec3> points) {
  const Box box = box_of(points);
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  order.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    order.emplace_back(hilbert_key(points[k], box), k);
  std::ranges::sort(order);
  std::vector<Vec3> sorted;
  sorted.reserve(points.size());
  for (const auto& [key, k] : order) sorted.push_back(points[k]);
  return sorted;
}

std::vector<std::int32_t> insertion_order(std::span<const Vec3> positions,
                                          std::span<const std::int32_t> nodes, const Box& box) {
  struct Item {
    std::uint64_t key;  // round in the top bits, place on the curve below
    std::int32_t node;
  };
  std::vector<Item> items;
  items.reserve(nodes.size());
  for (const std::int32_t node : nodes) {
    // A node falls into the last round with probability 7/8, else into the one before, and so on.
    std::uint64_t draw = Random(static_cast<std::uint64_t>(node)).next();
    std::uint64_t round = 15;
    while (round > 0 && (draw & 7U) == 0) {
      draw >>= 3;
      --round;
    }
    items.push_back({(round << 48) | hilbert_key(positions[node], box), node});
  }
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    return a.key != b.key ? a.key < b.key : a.node < b.node;
  });
  std::vector<std::int32_t> order;
  order.reserve(items.size());
  for (const Item& item : items) order.push_back(item.node);
  return order;
}

}  // namespace remeshd
