#include "client/library/array_delta.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "remeshd/error.h"
#include "tests/client/encode_delta.h"

namespace remeshd::client {
namespace {

using remesh::v1::ArrayDelta;

constexpr ArrayShape kI32{remesh::v1::ARRAY_TYPE_I32, 1};
constexpr ArrayShape kU64{remesh::v1::ARRAY_TYPE_U64, 1};
constexpr ArrayShape kU8{remesh::v1::ARRAY_TYPE_U8, 1};
constexpr ArrayShape kPairs{remesh::v1::ARRAY_TYPE_I32, 2};
constexpr ArrayShape kF64{remesh::v1::ARRAY_TYPE_F64, 1};

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}
std::string ints(const std::vector<std::int32_t>& values) { return bytes_of(values); }

struct Run {
  ArrayDelta::Kind kind;
  std::uint32_t count;
  std::int64_t start = 0;
};

ArrayDelta delta_of(const std::vector<Run>& runs, const std::string& rows = "") {
  ArrayDelta delta;
  for (const Run& run : runs) {
    delta.add_kinds(run.kind);
    delta.add_counts(run.count);
    delta.add_starts(run.start);
  }
  delta.set_rows(rows);
  return delta;
}

TEST(ArrayDelta, CopiesRunsOfTheBasesRowsFromWhereTheyWere) {
  // Row 2 of the base is gone, rows 0 and 1 come last.
  const auto delta = delta_of({{ArrayDelta::KIND_COPY, 2, 3}, {ArrayDelta::KIND_COPY, 2, -2}});
  EXPECT_EQ(apply_delta(delta, kI32, 4, ints({10, 11, 12, 13, 14})), ints({13, 14, 10, 11}));
}

TEST(ArrayDelta, TakesRowsOfItsOwnInOrder) {
  const auto delta = delta_of({{ArrayDelta::KIND_ROWS, 1},
                               {ArrayDelta::KIND_COPY, 1, 0},
                               {ArrayDelta::KIND_REPEAT, 3},
                               {ArrayDelta::KIND_ROWS, 1}},
                              ints({1, 2, 7, 8, 9, 9}));
  EXPECT_EQ(apply_delta(delta, kPairs, 6, ints({0, 0, 5, 6})),
            ints({1, 2, 5, 6, 7, 8, 7, 8, 7, 8, 9, 9}));
}

TEST(ArrayDelta, CountsUpInEveryTypeOfWholeNumbers) {
  EXPECT_EQ(apply_delta(delta_of({{ArrayDelta::KIND_COUNT, 2, -1}, {ArrayDelta::KIND_COUNT, 2, 7}}),
                        kI32, 4, ""),
            ints({-1, 0, 9, 10}));
  EXPECT_EQ(apply_delta(delta_of({{ArrayDelta::KIND_COUNT, 2, 254}}), kU8, 2, ""), "\xFE\xFF");
  constexpr std::uint64_t kLast = std::numeric_limits<std::uint64_t>::max();
  // Starts are modulo 2^64: -2 is the last number but one.
  EXPECT_EQ(apply_delta(delta_of({{ArrayDelta::KIND_COUNT, 2, -2}}), kU64, 2, ""),
            bytes_of<std::uint64_t>({kLast - 1, kLast}));
}

TEST(ArrayDelta, KeepsTheBitsOfNumbersThatAreEqualAndNotTheSame) {
  const std::string base = bytes_of<double>({-0.0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(apply_delta(delta_of({{ArrayDelta::KIND_COPY, 2}}), kF64, 2, base), base);
}

TEST(ArrayDelta, OfNoRunsIsAnEmptyArray) { EXPECT_EQ(apply_delta({}, kI32, 0, ints({1, 2})), ""); }

struct Fault {
  const char* name;
  ArrayDelta delta;
  ArrayShape shape = kI32;
  std::uint32_t count = 2;
};

class FaultyDelta : public testing::TestWithParam<Fault> {};

TEST_P(FaultyDelta, IsDamage) {
  try {
    (void)apply_delta(GetParam().delta, GetParam().shape, GetParam().count, ints({1, 2, 3}));
    FAIL() << "accepted";
  } catch (const CallError& e) {
    EXPECT_EQ(e.code(), remesh::v1::Error::CODE_DATA_LOSS);
    EXPECT_EQ(e.reason(), remesh::v1::Error::MESH_DAMAGED);
  }
}

ArrayDelta without_start(ArrayDelta delta) {
  delta.clear_starts();
  return delta;
}

constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();

INSTANTIATE_TEST_SUITE_P(
    All, FaultyDelta,
    testing::Values(
        Fault{"TooFewRows", delta_of({{ArrayDelta::KIND_COPY, 1}})},
        Fault{"TooManyRows", delta_of({{ArrayDelta::KIND_COPY, 3}})},
        Fault{"RowsThatComeToTheCountModulo2To32",
              delta_of({{ArrayDelta::KIND_REPEAT, 4'000'000'000},
                        {ArrayDelta::KIND_REPEAT, 294'967'298}},
                       ints({1, 2}))},
        Fault{"ListsOfUnequalLength", without_start(delta_of({{ArrayDelta::KIND_COPY, 2}}))},
        Fault{"EmptyRun", delta_of({{ArrayDelta::KIND_COPY, 0}, {ArrayDelta::KIND_COPY, 2}})},
        Fault{"CopyFromBehindTheEnd", delta_of({{ArrayDelta::KIND_COPY, 2, 2}})},
        Fault{"CopyFromFarBehindTheEnd",
              delta_of({{ArrayDelta::KIND_COPY, 2, std::numeric_limits<std::int64_t>::max()}})},
        Fault{"CopyFromBeforeTheFirstRow", delta_of({{ArrayDelta::KIND_COPY, 2, -1}})},
        Fault{"RowsThatAreNotThere", delta_of({{ArrayDelta::KIND_ROWS, 2}}, ints({1}))},
        Fault{"RepeatOfARowThatIsNotThere", delta_of({{ArrayDelta::KIND_REPEAT, 2}})},
        Fault{"RowsThatNoRunUses", delta_of({{ArrayDelta::KIND_COPY, 2}}, ints({1}))},
        Fault{"RowsWithAStart", delta_of({{ArrayDelta::KIND_ROWS, 2, 1}}, ints({1, 2}))},
        Fault{"UnknownKind", delta_of({{static_cast<ArrayDelta::Kind>(9), 2}})},
        Fault{"KindUnspecified", delta_of({{ArrayDelta::KIND_UNSPECIFIED, 2}})},
        Fault{"CountBeyondTheType", delta_of({{ArrayDelta::KIND_COUNT, 2, kMost}})},
        Fault{"CountFromBeyondTheType", delta_of({{ArrayDelta::KIND_COUNT, 2, 1LL << 40}})},
        Fault{"CountBelowTheType", delta_of({{ArrayDelta::KIND_COUNT, 2, -1}}), kU8},
        Fault{"CountPast2To64", delta_of({{ArrayDelta::KIND_COUNT, 2, -1}}), kU64},
        Fault{"CountInSeveralColumns", delta_of({{ArrayDelta::KIND_COUNT, 2}}), kPairs},
        Fault{"CountOfReals", delta_of({{ArrayDelta::KIND_COUNT, 2}}), kF64}),
    [](const auto& fault) { return std::string(fault.param.name); });

TEST(ArrayDelta, RebuildsWhatAnEncoderMadeOfIt) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::int32_t> base(random() % 50);
    for (auto& value : base) value = static_cast<std::int32_t>(random() % 4);
    std::vector<std::int32_t> array = base;
    array.resize(random() % 60, 3);
    for (auto& value : array)
      if (random() % 5 == 0) value = static_cast<std::int32_t>(random());
    const auto delta = encode_delta(ints(array), ints(base), 4, true);
    EXPECT_EQ(apply_delta(delta, kI32, static_cast<std::uint32_t>(array.size()), ints(base)),
              ints(array))
        << round;
  }
}

}  // namespace
}  // namespace remeshd::client
