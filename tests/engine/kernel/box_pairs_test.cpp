#include "engine/kernel/box_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/base/random.h"

namespace remeshd::kernel {
namespace {

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

Pairs found(const std::vector<Box>& boxes) {
  Pairs pairs;
  for_each_touching_pair(boxes, [&](std::int32_t a, std::int32_t b) { pairs.emplace_back(a, b); });
  std::ranges::sort(pairs);
  return pairs;
}

Pairs all(const std::vector<Box>& boxes) {
  Pairs pairs;
  for (std::size_t b = 0; b < boxes.size(); ++b)
    for (std::size_t a = 0; a < b; ++a)
      if (touch(boxes[a], boxes[b])) pairs.emplace_back(a, b);
  std::ranges::sort(pairs);
  return pairs;
}

TEST(BoxPairs, AreThoseOfAllAgainstAll) {
  Random random(3);
  std::vector<Box> boxes(1500);
  for (Box& box : boxes) {
    box.add(Vec3{random.uniform(), random.uniform(), random.uniform()});
    box.add(box.lo + Vec3{random.uniform(0, 0.2), random.uniform(0, 0.1), random.uniform(0, 0.1)});
  }
  const Pairs pairs = found(boxes);
  EXPECT_GT(pairs.size(), 1000U);
  EXPECT_EQ(pairs, all(boxes));
}

TEST(BoxPairs, FlatAndEqualBoxesAndThoseThatOnlyTouchAreFoundOnce) {
  // Cells of a lattice, each with a flat top, and the first layer twice.
  std::vector<Box> boxes;
  for (int layer : {0, 0, 1, 2, 3})
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) {
        const Vec3 lo{1.0 * i, 1.0 * j, 1.0 * layer};
        boxes.push_back({lo, lo + Vec3{1, 1, 1}});
        boxes.push_back({lo + Vec3{0, 0, 1}, lo + Vec3{1, 1, 1}});
      }
  EXPECT_EQ(found(boxes), all(boxes));
}

TEST(BoxPairs, NoneOfNoneOrOne) {
  EXPECT_TRUE(found({}).empty());
  EXPECT_TRUE(found({Box{.lo = {0, 0, 0}, .hi = {1, 1, 1}}}).empty());
}

}  // namespace
}  // namespace remeshd::kernel
