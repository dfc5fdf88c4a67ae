#include "tests/bench/sample.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <vector>

namespace remeshd::bench {
namespace {

constexpr std::array<Vec3, 4> kCorner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

TEST(DescribeMesh, TakesTetsTurnedEitherWay) {
  Sample right, wrong;
  describe_mesh(kCorner, std::array<Tet, 1>{{{0, 1, 2, 3}}}, right);
  describe_mesh(kCorner, std::array<Tet, 1>{{{1, 0, 2, 3}}}, wrong);
  EXPECT_EQ(right.nodes, 4U);
  EXPECT_EQ(right.tets, 1U);
  EXPECT_NEAR(right.quality.volume, 1.0 / 6, 1e-15);
  EXPECT_NEAR(wrong.quality.volume, 1.0 / 6, 1e-15);
  EXPECT_NEAR(right.quality.dihedral_min, 54.7356, 1e-3);
}

TEST(DescribeMesh, SeesTheOneTetThatIsTurnedOtherwise) {
  const std::vector<Vec3> nodes{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1.5}};
  Sample sample;
  describe_mesh(nodes, std::vector<Tet>{{0, 1, 2, 3}, {0, 1, 2, 4}}, sample);
  EXPECT_LT(sample.quality.volume_length_min, 0);
}

TEST(Meter, CountsTimeAndMemorySinceItsStart) {
  const std::vector<char> before(40'000'000, 'a');
  Meter meter;
  meter.start();
  double sum = 0;
  {
    const std::vector<char> large(60'000'000, 'b');
    for (const char c : large) sum += c;
  }
  Sample sample;
  meter.stop(sample);
  EXPECT_GT(sum, 0);
  EXPECT_GT(sample.cpu, 0);
  EXPECT_GT(sample.wall, 0);
  EXPECT_GT(sample.peak_bytes, 50e6);
  EXPECT_LT(sample.peak_bytes, 90e6);
  EXPECT_EQ(before.front(), 'a');
}

}  // namespace
}  // namespace remeshd::bench
