#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/error.h"
#include "engine/nodes/fill/fill.h"
#include "tests/support/run.h"

namespace remeshd {
namespace {

using test::kRun;
const Box kCube{{0, 0, 0}, {20, 20, 20}};

/// A field that is .5 on a vertical line through the cube's middle and 2 far away.
SizeField about_a_line() {
  const Surface line{Surface::Kind::Cylinder, Transform::translation({10, 10, 0}), 0.01, 0};
  const Box box{{9.99, 9.99, 0}, {10.01, 10.01, 20}};
  return SizeField({.base = 2, .least = 0.5, .slope = 0.3}, {{line, box, 0.5}}, kCube);
}

bool everywhere(const Vec3&) { return true; }

TEST(FillGraded, NeighboursStandAsFarApartAsTheFieldSays) {
  const SizeField sizes = about_a_line();
  const std::vector<Vec3> nodes = fill_graded({kCube}, everywhere, sizes, 1, kRun);
  ASSERT_GT(nodes.size(), 2000U);
  double sum = 0;
  int counted = 0;
  for (const Vec3& p : nodes) {
    if (!grown(kCube, -2).contains(p)) continue;
    double nearest = HUGE_VAL;
    for (const Vec3& q : nodes)
      if (p != q) nearest = std::fmin(nearest, distance(p, q));
    ASSERT_GE(nearest, 0.719 * std::fmin(sizes(p), sizes(p) - 0.3 * nearest));
    ASSERT_LE(nearest, 1.25 * sizes(p));
    sum += nearest / sizes(p);
    ++counted;
  }
  EXPECT_NEAR(sum / counted, 0.85, 0.1);
}

TEST(FillGraded, WhereTheModelAsksForALengthTheyAreAsDenseWhateverShareOfTheBaseSizeItIs) {
  const Surface top{Surface::Kind::Plane, Transform::translation({0, 0, 20}), 0, 0};
  for (const double length : {0.55, 0.6, 0.66, 0.7, 0.8, 0.84, 0.9, 1.0}) {
    const SizeField sizes(
        {.base = 2, .least = 0.2, .slope = 0.3},
        {{.piece = top, .box = kCube, .size = length, .asked = true, .filled = true}}, kCube);
    const auto nodes = static_cast<double>(fill_graded({kCube}, everywhere, sizes, 1, kRun).size());
    const double density = nodes * std::pow(length / 20, 3) / std::sqrt(2);
    EXPECT_GT(density, 0.6) << length;
    EXPECT_LT(density, 1.3) << length;
  }
}

TEST(FillGraded, OverlappingBoxesAreFilledOnce) {
  const SizeField sizes = about_a_line();
  const Box lower{{0, 0, 0}, {20, 20, 12}}, upper{{0, 0, 8}, {20, 20, 20}};
  EXPECT_EQ(fill_graded({lower, upper}, everywhere, sizes, 1, kRun),
            fill_graded({kCube}, everywhere, sizes, 1, kRun));
}

TEST(FillGraded, OnlyWhatIsInsideIsFilled) {
  const auto half = [](const Vec3& p) { return p.x < 10; };
  const std::vector<Vec3> nodes = fill_graded({kCube}, half, about_a_line(), 1, kRun);
  EXPECT_FALSE(nodes.empty());
  EXPECT_TRUE(std::ranges::all_of(nodes, half));
  EXPECT_TRUE(fill_graded(
                  {kCube}, [](const Vec3&) { return false; }, about_a_line(), 1, kRun)
                  .empty());
}

TEST(FillGraded, TheSameNodesOnAnyNumberOfThreads) {
  remeshd::Run two;
  two.threads = 2;
  EXPECT_EQ(fill_graded({kCube}, everywhere, about_a_line(), 1, two),
            fill_graded({kCube}, everywhere, about_a_line(), 1, kRun));
  EXPECT_NE(fill_graded({kCube}, everywhere, about_a_line(), 2, kRun),
            fill_graded({kCube}, everywhere, about_a_line(), 1, kRun));
}

TEST(FillGraded, EndsAfterAStop) {
  std::stop_source stop;
  remeshd::Run run;
  run.stop = stop.get_token();
  const auto inside = [&](const Vec3&) {
    stop.request_stop();
    return true;
  };
  EXPECT_THROW(fill_graded({{{0, 0, 0}, {300, 300, 300}}}, inside, about_a_line(), 1, run), Error);
}

}  // namespace
}  // namespace remeshd
