#include "server/store/array_codec.h"

#include <xxhash.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <memory>

#include "engine/base/error.h"
#include "proto/checksum.h"
#include "server/store/store_error.h"

namespace remeshd {
namespace {

// A higher level saves some 5 % and takes twice as long.
constexpr int kArrayLevel = 1;
// Where more than one page in `kFewPages` differs, rows may have moved, and a Patch may be shorter.
// For arrays of more than `kMostPatched` bytes, trying takes longer than it saves.
constexpr std::size_t kFewPages = 4;  // one in so many
constexpr std::size_t kMostPatched = std::size_t{1} << 18;
constexpr std::uint64_t kMostArrayBytes = std::uint64_t{1} << 36;  // of a decoded array

constexpr std::uint64_t kMostArrayGrowth = std::uint64_t{1}
                                           << 15;  // zstd makes 128 KiB of four bytes

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

Error corrupted(const std::string& array) {
  return error::store_corrupted("", "the array " + array + " cannot be decoded");
}

/// The context of this thread, reset: making one takes longer than compressing a small array.
ZSTD_CCtx* compressor() {
  thread_local const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
  ZSTD_CCtx_reset(context.get(), ZSTD_reset_session_and_parameters);
  return context.get();
}
ZSTD_DCtx* decompressor() {
  thread_local const std::unique_ptr<ZSTD_DCtx, FreeContext> context(ZSTD_createDCtx());
  ZSTD_DCtx_reset(context.get(), ZSTD_reset_session_and_parameters);
  return context.get();
}

/// zstd's windowLog for so many bytes of prefix and content together.
int window_for(std::size_t bytes) {
  int log = 17;
  while (log < 30 && (std::size_t{1} << log) < 2 * bytes) ++log;
  return log;
}

std::string compress(std::string_view bytes, std::string_view prefix = {}) {
  ZSTD_CCtx* const context = compressor();
  ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, kArrayLevel);
  if (!prefix.empty()) {
    ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, window_for(prefix.size() + bytes.size()));
    ZSTD_CCtx_refPrefix(context, prefix.data(), prefix.size());
  }
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context, out.data(), out.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(size)) throw error::internal("store", ZSTD_getErrorName(size));
  out.resize(size);
  return out;
}

std::string decompress(const std::string& name, std::string_view data, std::uint64_t bytes,
                       std::string_view prefix = {}) {
  if (ZSTD_getFrameContentSize(data.data(), data.size()) != bytes ||
      bytes / kMostArrayGrowth > data.size())
    throw corrupted(name);
  ZSTD_DCtx* const context = decompressor();
  if (!prefix.empty()) {
    ZSTD_DCtx_setParameter(context, ZSTD_d_windowLogMax, 31);
    ZSTD_DCtx_refPrefix(context, prefix.data(), prefix.size());
  }
  std::string out(bytes, '\0');
  const std::size_t size =
      ZSTD_decompressDCtx(context, out.data(), out.size(), data.data(), data.size());
  if (ZSTD_isError(size) || size != bytes) throw corrupted(name);
  return out;
}

// The loops below use bare pointers so that the compiler can vectorise them: the index checks of
// std::string, which are on in every build, would prevent that and make them ten times slower.

/// Writes byte planes (byte 0 of all `numbers`, then byte 1 of all, ...), so that alike bytes lie
/// together. `bytes` are some of these numbers, from index `first` on.
template <std::size_t width>
void take_apart(std::string_view bytes, std::size_t first, std::size_t numbers, char* planes) {
  const std::size_t count = bytes.size() / width;
  const char* const from = bytes.data();
  for (std::size_t b = 0; b < width; ++b) {
    char* __restrict const plane = planes + b * numbers + first;
    for (std::size_t i = 0; i < count; ++i) plane[i] = from[i * width + b];
  }
}
void take_apart(std::string_view bytes, std::size_t width, std::size_t first, std::size_t numbers,
                char* planes) {
  if (width == 8) return take_apart<8>(bytes, first, numbers, planes);
  if (width == 4) return take_apart<4>(bytes, first, numbers, planes);
  std::copy(bytes.begin(), bytes.end(), planes + first);
}

std::string transposed(const StoredArray& array, std::size_t width) {
  std::string out(array.size(), '\0');
  std::size_t first = 0;
  for (const std::string_view piece : array.pieces) {
    take_apart(piece, width, first, out.size() / width, out.data());
    first += piece.size() / width;
  }
  return out;
}

template <std::size_t width>
std::string put_together(std::string_view planes) {
  const std::size_t count = planes.size() / width;
  std::string out(planes.size(), '\0');
  const char* const from = planes.data();
  char* __restrict const to = out.data();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t b = 0; b < width; ++b) to[i * width + b] = from[b * count + i];
  return out;
}
std::string transposed_back(std::string_view planes, std::size_t width) {
  return width == 8   ? put_together<8>(planes)
         : width == 4 ? put_together<4>(planes)
                      : std::string(planes);
}

/// XORs `base` into `page`: a page becomes its difference, and a difference the page. What the base
/// lacks counts as zero.
void exclusive_or(char* __restrict page, std::size_t size, std::string_view base) {
  const std::size_t common = std::min(size, base.size());
  const char* const other = base.data();
  for (std::size_t i = 0; i < common; ++i) page[i] = static_cast<char>(page[i] ^ other[i]);
}

std::string_view piece_of(const StoredArray& array, std::size_t k) {
  return k < array.pieces.size() ? array.pieces[k] : std::string_view();
}

/// State of a page in the encoding Pages.
enum : std::uint8_t { kSame = 0, kDifference = 1, kWhole = 2 };

struct Pages {
  std::string states;  ///< a byte a page
  PageDepths depths;
  std::size_t count = 0;  ///< of pages that differ from the base's
  std::size_t bytes = 0;  ///< of those pages
};

Pages differing_pages(const StoredArray& array, const DecodedArray& base) {
  Pages out;
  for (std::size_t k = 0; k < array.pieces.size(); ++k) {
    const std::string_view page = array.pieces[k], before = piece_of(base.array, k);
    const std::uint8_t depth = k < base.depths.size() ? base.depths[k] : 0;
    if (page.size() == before.size() && (page.data() == before.data() || page == before)) {
      out.states += static_cast<char>(kSame);
      out.depths.push_back(depth);
      continue;
    }
    const bool whole = before.empty() || depth >= kMostDepth;
    out.states += static_cast<char>(whole ? kWhole : kDifference);
    out.depths.push_back(whole ? 0 : depth + 1);
    ++out.count;
    out.bytes += page.size();
  }
  return out;
}

/// The encoding Pages before compression: states, depths, then the pages that differ, as byte
/// planes.
std::string plain_pages(const Pages& pages, const StoredArray& array, const DecodedArray& base) {
  const std::size_t width = bytes_of(array.type), start = 2 * pages.states.size();
  std::string plain = pages.states;
  plain.append(pages.depths.begin(), pages.depths.end());
  plain.resize(start + pages.bytes);
  std::string difference;
  std::size_t first = 0;
  for (std::size_t k = 0; k < array.pieces.size(); ++k) {
    if (pages.states[k] == kSame) continue;
    std::string_view page = array.pieces[k];
    if (pages.states[k] == kDifference) {
      difference = page;
      exclusive_or(difference.data(), difference.size(), piece_of(base.array, k));
      page = difference;
    }
    take_apart(page, width, first, pages.bytes / width, plain.data() + start);
    first += page.size() / width;
  }
  return plain;
}

void check_encoded(const EncodedArray& encoded) {
  const std::size_t element = bytes_of(encoded.type) * encoded.components;
  if (element == 0 || encoded.bytes % element != 0 || encoded.piece_bytes == 0 ||
      encoded.piece_bytes % element != 0 || encoded.bytes > kMostArrayBytes ||
      encoded.piece_bytes > kMostArrayBytes)
    throw corrupted(encoded.name);
}

}  // namespace

EncodedArray encode(const StoredArray& array, const DecodedArray* base, PageDepths& depths) {
  EncodedArray out{.name = array.name,
                   .type = array.type,
                   .components = array.components,
                   .bytes = array.size(),
                   .piece_bytes = array.piece_bytes};
  const std::size_t width = bytes_of(array.type);
  const bool comparable = base && base->array.type == array.type &&
                          base->array.components == array.components &&
                          base->array.piece_bytes == array.piece_bytes && out.bytes > 0;
  if (!comparable) {
    out.data = compress(transposed(array, width));
    depths.assign(array.pieces.size(), 0);
    return out;
  }
  Pages pages = differing_pages(array, *base);
  out.encoding = ArrayEncoding::Pages;
  out.data = compress(plain_pages(pages, array, *base));
  depths = std::move(pages.depths);
  if (pages.count * kFewPages <= array.pieces.size()) return out;

  const std::uint8_t deepest =
      base->depths.empty() ? 0 : *std::max_element(base->depths.begin(), base->depths.end());
  if (deepest < kMostDepth && base->array.size() > 0 && out.bytes <= kMostPatched) {
    std::string patch = compress(array.flat(), base->array.flat());
    if (patch.size() < out.data.size()) {
      out.encoding = ArrayEncoding::Patch;
      out.data = std::move(patch);
      depths.assign(array.pieces.size(), deepest + 1);
    }
  }
  // Little was saved: the array without a base may be shorter.
  if (out.data.size() * kFewPages < out.bytes) return out;
  std::string full = compress(transposed(array, width));
  if (full.size() < out.data.size()) {
    out.encoding = ArrayEncoding::Full;
    out.data = std::move(full);
    depths.assign(array.pieces.size(), 0);
  }
  return out;
}

DecodedArray decode(const EncodedArray& encoded, const DecodedArray* base) {
  check_encoded(encoded);
  const std::size_t width = bytes_of(encoded.type);
  DecodedArray out;
  out.array = {.name = encoded.name,
               .type = encoded.type,
               .components = encoded.components,
               .pieces = {},
               .piece_bytes = encoded.piece_bytes,
               .owned = {}};
  const std::size_t count = (encoded.bytes + encoded.piece_bytes - 1) / encoded.piece_bytes;
  if (encoded.encoding == ArrayEncoding::Full) {
    out.array.own(transposed_back(decompress(encoded.name, encoded.data, encoded.bytes), width));
    out.depths.assign(count, 0);
    return out;
  }
  if (base == nullptr) throw corrupted(encoded.name);
  if (encoded.encoding == ArrayEncoding::Patch) {
    out.array.own(decompress(encoded.name, encoded.data, encoded.bytes, base->array.flat()));
    const std::uint8_t deepest =
        base->depths.empty() ? 0 : *std::max_element(base->depths.begin(), base->depths.end());
    out.depths.assign(count, deepest + 1);
    return out;
  }

  const std::uint64_t plain_bytes =
      ZSTD_getFrameContentSize(encoded.data.data(), encoded.data.size());
  if (plain_bytes == ZSTD_CONTENTSIZE_ERROR || plain_bytes == ZSTD_CONTENTSIZE_UNKNOWN ||
      plain_bytes < 2 * count || plain_bytes > 2 * count + encoded.bytes)
    throw corrupted(encoded.name);
  const std::string plain = decompress(encoded.name, encoded.data, plain_bytes);
  const std::string_view states = std::string_view(plain).substr(0, count);
  out.depths.assign(plain.begin() + static_cast<std::ptrdiff_t>(count),
                    plain.begin() + static_cast<std::ptrdiff_t>(2 * count));
  std::string changed = transposed_back(std::string_view(plain).substr(2 * count), width);
  std::string bytes(encoded.bytes, '\0');
  std::size_t taken = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t at = k * encoded.piece_bytes;
    const std::size_t size = std::min<std::size_t>(encoded.piece_bytes, bytes.size() - at);
    const std::string_view before = piece_of(base->array, k);
    if (states[k] == kSame) {
      if (before.size() != size) throw corrupted(encoded.name);
      std::copy(before.begin(), before.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
      continue;
    }
    if (changed.size() - taken < size) throw corrupted(encoded.name);
    std::copy_n(changed.begin() + static_cast<std::ptrdiff_t>(taken), size,
                bytes.begin() + static_cast<std::ptrdiff_t>(at));
    if (states[k] == kDifference) exclusive_or(bytes.data() + at, size, before);
    taken += size;
  }
  if (taken != changed.size()) throw corrupted(encoded.name);
  out.array.own(std::move(bytes));
  return out;
}

namespace {

std::string digits(XXH128_hash_t hash) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, hash);
  return to_hex({reinterpret_cast<const char*>(canonical.digest), sizeof canonical.digest});
}

}  // namespace

std::string content_hash(std::string_view bytes) {
  return digits(XXH3_128bits(bytes.data(), bytes.size()));
}

std::string content_hash(const StoredArrays& arrays) {
  struct FreeState {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
  XXH3_128bits_reset(state.get());
  const auto add = [&](std::string_view bytes) {
    XXH3_128bits_update(state.get(), bytes.data(), bytes.size());
  };
  for (const StoredArray& array : arrays.arrays) {
    add(array.name + " " + std::to_string(static_cast<int>(array.type)) + " " +
        std::to_string(array.components) + " " + std::to_string(array.size()) + "\n");
    for (const std::string_view piece : array.pieces) add(piece);
  }
  return digits(XXH3_128bits_digest(state.get()));
}

}  // namespace remeshd
