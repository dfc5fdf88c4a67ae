#include "server/store/array_codec.h"

#include <gmock/gmock.h>

#include <cstring>
#include <random>

#include "engine/base/error.h"

namespace remeshd {
namespace {

StoredArray array_of(const std::vector<std::int32_t>& values, std::uint32_t components = 1) {
  StoredArray array{.name = "a", .type = StoredType::I32, .components = components};
  array.own({reinterpret_cast<const char*>(values.data()), 4 * values.size()});
  return array;
}

std::vector<std::int32_t> some_values(std::size_t count, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::vector<std::int32_t> values(count);
  for (std::int32_t& v : values) v = static_cast<std::int32_t>(random() % 100000);
  return values;
}

DecodedArray decoded(const StoredArray& array) {
  return {array, PageDepths(array.pieces.size(), 0)};
}

/// Encodes against the base, decodes with it, and expects the same.
EncodedArray expect_round_trip(const StoredArray& array, const DecodedArray* base) {
  PageDepths depths;
  EncodedArray encoded = encode(array, base, depths);
  const DecodedArray back = decode(encoded, base);
  EXPECT_TRUE(back.array.flat() == array.flat());
  EXPECT_EQ(back.depths, depths);
  EXPECT_EQ(back.array.name, array.name);
  EXPECT_EQ(back.array.type, array.type);
  EXPECT_EQ(back.array.components, array.components);
  return encoded;
}

TEST(ArrayCodec, AnArrayByItselfComesBack) {
  for (const std::size_t count : {0, 1, 1023, 1024, 1025, 5000})
    expect_round_trip(array_of(some_values(count)), nullptr);
}

TEST(ArrayCodec, AFewChangesCostAFewBytes) {
  std::vector<std::int32_t> values = some_values(100000);
  const DecodedArray base = decoded(array_of(values));
  for (const std::size_t at : {5, 20000, 70000}) values[at] += 1;
  const EncodedArray encoded = expect_round_trip(array_of(values), &base);
  EXPECT_EQ(encoded.encoding, ArrayEncoding::Pages);
  EXPECT_LT(encoded.data.size(), 200U);
}

TEST(ArrayCodec, ArraysThatGrowShrinkOrEndComeBack) {
  const std::vector<std::int32_t> values = some_values(5000);
  const DecodedArray base = decoded(array_of(values));
  for (const std::size_t count : {0, 1, 1024, 4999, 5000, 5001, 7000, 20000}) {
    std::vector<std::int32_t> other = values;
    other.resize(count, 7);
    expect_round_trip(array_of(other), &base);
  }
}

TEST(ArrayCodec, RowsThatMovedArePatched) {
  std::vector<std::int32_t> values = some_values(30000);
  const DecodedArray base = decoded(array_of(values));
  values.insert(values.begin() + 100, {1, 2, 3});
  const EncodedArray encoded = expect_round_trip(array_of(values), &base);
  EXPECT_EQ(encoded.encoding, ArrayEncoding::Patch);
  EXPECT_LT(encoded.data.size(), 300U);
}

TEST(ArrayCodec, WhatHasNothingInCommonIsWrittenByItself) {
  const DecodedArray base = decoded(array_of(some_values(30000, 1)));
  const EncodedArray encoded = expect_round_trip(array_of(some_values(30000, 2)), &base);
  EXPECT_EQ(encoded.encoding, ArrayEncoding::Full);
}

TEST(ArrayCodec, AnArrayOfAnotherTypeIsNoBase) {
  const DecodedArray base = decoded(array_of(some_values(3000)));
  EXPECT_EQ(expect_round_trip(array_of(some_values(3000), 3), &base).encoding, ArrayEncoding::Full);
}

TEST(ArrayCodec, DifferencesAreAtMostEightDeep) {
  std::vector<std::int32_t> values = some_values(8 * 1024);
  DecodedArray base = decoded(array_of(values));
  int deepest = 0;
  for (int i = 0; i < 40; ++i) {
    values[3] += 1;                     // a page that always changes
    if (i % 3 == 0) values[5000] += 1;  // one that changes now and then
    const StoredArray array = array_of(values);
    PageDepths depths;
    base = decode(encode(array, &base, depths), &base);
    EXPECT_TRUE(base.array.flat() == array.flat());
    EXPECT_EQ(base.depths[7], 0);
    for (const std::uint8_t depth : base.depths) deepest = std::max<int>(deepest, depth);
  }
  EXPECT_EQ(deepest, kMostDepth);
}

TEST(ArrayCodec, PatchesAreAtMostEightDeep) {
  std::vector<std::int32_t> values = some_values(30000);
  DecodedArray base = decoded(array_of(values));
  for (int i = 0; i < 20; ++i) {
    values.insert(values.begin() + 10, i);
    PageDepths depths;
    base = decode(encode(array_of(values), &base, depths), &base);
    for (const std::uint8_t depth : base.depths) ASSERT_LE(depth, kMostDepth);
  }
}

TEST(ArrayCodec, DamagedDataAreAnErrorOrAnotherArrayAndNeverMore) {
  std::vector<std::int32_t> values = some_values(9000);
  const DecodedArray base = decoded(array_of(values));
  for (int kind = 0; kind < 3; ++kind) {
    if (kind == 1) values[100] += 1;
    if (kind == 2) values.insert(values.begin() + 10, 5);
    PageDepths depths;
    const DecodedArray* with = kind == 0 ? nullptr : &base;
    const EncodedArray whole = encode(array_of(values), with, depths);
    std::mt19937 random(3);
    for (int i = 0; i < 300; ++i) {
      EncodedArray damaged = whole;
      const std::size_t at = random() % damaged.data.size();
      damaged.data[at] = static_cast<char>(damaged.data[at] ^ (1 << random() % 8));
      if (i % 3 == 0) damaged.data.resize(at);
      if (i % 7 == 0) damaged.bytes = 4 * (random() % 10000);
      try {
        static_cast<void>(decode(damaged, with));
      } catch (const Error& failure) {
        EXPECT_EQ(failure.info().stage, "store");
      }
    }
  }
}

TEST(ArrayCodec, PagesLargerThanAnyArrayAreRefused) {
  PageDepths depths;
  EncodedArray encoded = encode(array_of({1, 2, 3, 4}), nullptr, depths);
  const std::size_t element = bytes_of(encoded.type) * encoded.components;
  encoded.piece_bytes = ~std::uint64_t{0} / element * element;  // rounding up to pages would wrap
  EXPECT_THROW(static_cast<void>(decode(encoded, nullptr)), Error);
}

TEST(ArrayCodec, TheContentHashTellsBytesNamesAndTypes) {
  const StoredArrays arrays{{array_of({1, 2, 3, 4})}};
  const std::string hash = content_hash(arrays);
  EXPECT_EQ(hash.size(), 32U);
  StoredArrays other = arrays;
  EXPECT_EQ(content_hash(other), hash);
  other.arrays[0].name = "b";
  EXPECT_NE(content_hash(other), hash);
  other = arrays;
  other.arrays[0].components = 2;
  EXPECT_NE(content_hash(other), hash);
  EXPECT_NE(content_hash(StoredArrays{{array_of({1, 2, 3, 5})}}), hash);
  // Not how it is cut into pieces.
  other = arrays;
  other.arrays[0].piece_bytes = 8;
  other.arrays[0].own(arrays.arrays[0].flat());
  EXPECT_EQ(content_hash(other), hash);
}

}  // namespace
}  // namespace remeshd
