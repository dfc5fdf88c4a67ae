#include "server/service/array_delta.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "client/library/array_delta.h"

namespace remeshd {
namespace {

using remesh::v1::ArrayDelta;

template <typename Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

template <typename Number>
constexpr NumberType kTypeOf = NumberType::I32;
template <>
constexpr NumberType kTypeOf<double> = NumberType::F64;
template <>
constexpr NumberType kTypeOf<std::uint64_t> = NumberType::U64;
template <>
constexpr NumberType kTypeOf<std::uint8_t> = NumberType::U8;

/// The delta between two arrays, after the client library has rebuilt the second by it.
template <typename Number>
ArrayDelta delta(const std::vector<Number>& base, const std::vector<Number>& numbers,
                 std::uint32_t components = 1) {
  const auto rows = static_cast<std::uint32_t>(numbers.size() / components);
  const std::string bytes = bytes_of(numbers), of_base = bytes_of(base);
  const MeshArray array{.name = ArrayName::Nodes,
                        .type = kTypeOf<Number>,
                        .components = components,
                        .count = rows,
                        .bytes = bytes.size(),
                        .from = {}};
  const ArrayDelta made = delta_of(array, bytes, of_base);
  const client::ArrayShape shape{static_cast<remesh::v1::ArrayType>(kTypeOf<Number>), components};
  EXPECT_EQ(client::apply_delta(made, shape, rows, of_base), bytes);
  return made;
}

std::vector<std::int32_t> count_from(std::int32_t first, std::size_t rows) {
  std::vector<std::int32_t> numbers(rows);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

/// Numbers that neither repeat nor count up.
std::vector<std::int32_t> scattered(std::size_t rows) {
  std::mt19937 random(7);
  std::vector<std::int32_t> numbers(rows);
  for (std::int32_t& number : numbers) number = static_cast<std::int32_t>(random());
  return numbers;
}

TEST(ArrayDeltaMade, CopiesWhatStaysWhereItWas) {
  auto now = scattered(1000);
  const auto before = now;
  now[500] = 1;
  const ArrayDelta made = delta(before, now);
  ASSERT_EQ(made.kinds_size(), 3);
  EXPECT_EQ(made.kinds(1), ArrayDelta::KIND_ROWS);
  EXPECT_EQ(made.rows(), bytes_of<std::int32_t>({1}));
}

TEST(ArrayDeltaMade, CopiesRowsFromWhereTheyWentTo) {
  const auto before = scattered(2000);
  auto now = before;
  now.erase(now.begin() + 400, now.begin() + 404);  // two rows
  now.insert(now.begin(), {1, 2, 3, 4});
  const ArrayDelta made = delta(before, now, 2);
  EXPECT_LT(made.rows().size(), 200U);
  EXPECT_LE(made.kinds_size(), 5);
}

TEST(ArrayDeltaMade, TellsNumbersThatCountUpByTheirFirst) {
  auto now = count_from(0, 1000);
  now[300] = -1;
  const ArrayDelta made = delta({}, now);
  EXPECT_EQ(made.kinds_size(), 3);
  EXPECT_EQ(made.kinds(0), ArrayDelta::KIND_COUNT);
  EXPECT_EQ(made.starts(2), 0);
  constexpr std::uint64_t kLast = std::numeric_limits<std::uint64_t>::max();
  delta<std::uint64_t>({}, {kLast - 2, kLast - 1, kLast, 0, 1, 2, 3});
  delta<std::uint8_t>({}, {250, 251, 252, 253, 254, 255, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  delta<std::int32_t>({}, count_from(std::numeric_limits<std::int32_t>::min(), 100));
}

TEST(ArrayDeltaMade, TellsARowThatRepeatsOnce) {
  const ArrayDelta made = delta<std::uint8_t>({}, std::vector<std::uint8_t>(5000, 1));
  EXPECT_EQ(made.rows().size(), 1U);
  EXPECT_EQ(made.kinds(0), ArrayDelta::KIND_REPEAT);
}

TEST(ArrayDeltaMade, KeepsTheBitsOfNumbersThatAreEqualAndNotTheSame) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  delta<double>({0.0, 0.0, 0.0, nan, 1, 2}, {-0.0, 0.0, 0.0, nan, 1, 2}, 3);
}

TEST(ArrayDeltaMade, OfAnEmptyArrayIsEmpty) {
  EXPECT_EQ(delta<std::int32_t>({1, 2}, {}).kinds_size(), 0);
  delta<std::int32_t>({}, {1, 2});
}

TEST(ArrayDeltaMade, IsNeverMuchLongerThanTheRowsThatChanged) {
  std::mt19937 random(3);
  for (const std::size_t every : {2U, 3U, 10U, 100U}) {
    auto now = scattered(40000);
    const auto before = now;
    std::size_t changed = 0;
    for (std::size_t row = 0; row < now.size() / 4; ++row)
      if (random() % every == 0) {
        now[4 * row + random() % 4] += 1;
        ++changed;
      }
    EXPECT_LT(delta(before, now, 4).ByteSizeLong(), changed * 26 + 100) << every;
  }
}

TEST(ArrayDeltaMade, RebuildsWhateverChanged) {
  std::mt19937 random(11);
  const auto below = [&](std::size_t limit) { return random() % limit; };
  for (int turn = 0; turn < 300; ++turn) {
    std::vector<std::int32_t> now(3 * below(60));
    for (std::int32_t& number : now) number = static_cast<std::int32_t>(below(4));
    const auto before = now;
    for (std::size_t k = below(5); k > 0; --k) {
      const auto at = static_cast<std::ptrdiff_t>(3 * below(now.size() / 3 + 1));
      if (below(2) == 0) {
        now.insert(now.begin() + at, {1, 2, static_cast<std::int32_t>(below(3))});
      } else if (at < static_cast<std::ptrdiff_t>(now.size())) {
        now.erase(now.begin() + at, now.begin() + at + 3);
      }
    }
    delta(before, now, 1);
    delta(before, now, 3);
  }
}

}  // namespace
}  // namespace remeshd
