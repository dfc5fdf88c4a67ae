// Arrays of a pack, whole or as differences to those of a base. What zstd packed is packed here,
// for mutations of packed bytes seldom get past zstd's own checks.
#include "server/store/array_codec.h"

#include "server/store/packed_text.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/targets.h"

namespace remeshd::fuzz {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 18;  // a pack's head may name any number
constexpr std::uint8_t kPack = 1, kBase = 2;                  // bits of the first byte

/// Rows of three numbers in pages of 96 bytes, the second of which is a difference already.
DecodedArray base_array() {
  DecodedArray base;
  base.array = {.name = "nodes", .type = StoredType::F64, .components = 3, .piece_bytes = 96};
  std::string bytes;
  for (int k = 0; k < 960; ++k) bytes += static_cast<char>(k % 251);
  base.array.own(bytes);
  base.depths.assign(base.array.pieces.size(), 0);
  base.depths[1] = 3;
  base.depths[2] = kMostDepth;
  return base;
}

void check(Input input) {
  const std::uint8_t how = input.byte();
  EncodedArray encoded{.name = "nodes", .base = "nodes"};
  encoded.encoding = ArrayEncoding{static_cast<std::uint8_t>(input.byte() % 5)};
  encoded.type = StoredType{static_cast<std::uint8_t>(input.byte() % 6)};
  encoded.components = static_cast<std::uint32_t>(input.number(2));
  encoded.bytes = input.number(how & 4 ? 8 : 2);
  encoded.piece_bytes = input.number(how & 8 ? 8 : 2);
  const std::string_view rest = input.rest();
  encoded.data = (how & kPack) != 0 ? packed(rest) : std::string(rest);
  encoded.data_bytes = encoded.data.size();
  if (encoded.bytes > kMostBytes) return;

  static const DecodedArray base = base_array();
  const DecodedArray* const against = (how & kBase) != 0 ? &base : nullptr;
  const DecodedArray decoded = decode(encoded, against);
  expect(decoded.array.size() == encoded.bytes, "an array of another size than its head says");
  expect(decoded.depths.size() == decoded.array.pieces.size(), "a depth for each page");

  PageDepths depths;
  const EncodedArray again = encode(decoded.array, against, depths);
  const DecodedArray back = decode(again, against);
  expect(back.array.flat() == decoded.array.flat(), "an array that is stored is another");
  expect(back.depths == depths, "depths are told wrong");
}

std::string seed(std::uint8_t how, const EncodedArray& encoded, const std::string& data) {
  std::string out;
  const auto put = [&](std::uint64_t value, int bytes) {
    for (int k = 0; k < bytes; ++k) out += static_cast<char>(value >> (8 * k));
  };
  put(how, 1);
  put(static_cast<std::uint8_t>(encoded.encoding), 1);
  put(static_cast<std::uint8_t>(encoded.type), 1);
  put(encoded.components, 2);
  put(encoded.bytes, 2);
  put(encoded.piece_bytes, 2);
  return out + data;
}

}  // namespace
}  // namespace remeshd::fuzz

int fuzz_array_codec(const std::uint8_t* data, std::size_t size) {
  try {
    remeshd::fuzz::check({data, size});
  } catch (const remeshd::Error& error) {
    remeshd::fuzz::expect(!error.info().message.empty(), "an error without a message");
  }
  return 0;
}

remeshd::fuzz::Seeds remeshd::fuzz::array_codec_seeds() {
  Seeds seeds;
  const DecodedArray base = base_array();
  DecodedArray changed = base;
  std::string bytes = base.array.flat();
  bytes[5] = bytes[100] = bytes[200] = 'x';
  changed.array.own(bytes + std::string(48, 'y'));
  for (const DecodedArray* against : {static_cast<const DecodedArray*>(nullptr), &base}) {
    PageDepths depths;
    const EncodedArray encoded = encode(changed.array, against, depths);
    const std::uint8_t how = against != nullptr ? kBase : 0;
    seeds.push_back(seed(how, encoded, encoded.data));
    if (encoded.encoding == ArrayEncoding::Patch) continue;
    seeds.push_back(seed(how | kPack, encoded, unpacked(encoded.data)));
  }
  changed.array.own(bytes.substr(24) + bytes.substr(0, 24));  // rows that moved: a patch
  PageDepths depths;
  const EncodedArray moved = encode(changed.array, &base, depths);
  seeds.push_back(seed(kBase, moved, moved.data));
  return seeds;
}
