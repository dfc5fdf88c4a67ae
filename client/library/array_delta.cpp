// SPDX-License-Identifier: Apache-2.0
#include "client/library/array_delta.h"

#include <cstring>
#include <limits>

#include "client/library/mesh_damaged.h"

namespace remeshd::client {
namespace {

using remesh::v1::ArrayDelta;

/// Appends runs of rows, one after the other.
class Rebuilder {
 public:
  Rebuilder(const ArrayDelta& delta, const ArrayShape& shape, std::string_view base)
      : delta_(delta), shape_(shape), row_(row_bytes(shape)), base_(base) {}

  std::string rebuild(std::uint32_t count) {
    if (delta_.counts_size() != delta_.kinds_size() || delta_.starts_size() != delta_.kinds_size())
      mesh_damaged("the lists of a delta differ in length");
    // Checked before memory is taken: a repeated row makes many bytes of few.
    std::uint64_t rows = 0;
    for (const std::uint32_t run : delta_.counts()) rows += run;
    if (rows != count) mesh_damaged("a delta has the wrong number of rows");
    out_.reserve(count * row_);
    for (int k = 0; k < delta_.kinds_size(); ++k)
      add_run(delta_.kinds(k), delta_.counts(k), delta_.starts(k));
    if (used_ != delta_.rows().size()) mesh_damaged("a delta has rows that no run uses");
    return std::move(out_);
  }

 private:
  void add_run(int kind, std::uint32_t count, std::int64_t start) {
    if (count == 0) mesh_damaged("a delta has an empty run");
    const bool starts_somewhere = kind == ArrayDelta::KIND_COPY || kind == ArrayDelta::KIND_COUNT;
    if (start != 0 && !starts_somewhere) mesh_damaged("a run of rows has a start");
    switch (kind) {
      case ArrayDelta::KIND_COPY:
        return copy(count, start);
      case ArrayDelta::KIND_ROWS:
        out_ += own_rows(count);
        return;
      case ArrayDelta::KIND_REPEAT:
        return repeat(count);
      case ArrayDelta::KIND_COUNT:
        return count_up(count, start);
      default:
        mesh_damaged("a delta has a run of a kind that is not known");
    }
  }

  [[nodiscard]] std::uint64_t next_row() const { return out_.size() / row_; }

  void copy(std::uint32_t count, std::int64_t start) {
    // Wraps round where the first row would be negative, which is beyond the base's end too.
    const std::uint64_t first = next_row() + static_cast<std::uint64_t>(start);
    const std::uint64_t rows = base_.size() / row_;
    if (first > rows || count > rows - first)
      mesh_damaged("a delta copies rows that are not there");
    out_ += base_.substr(first * row_, count * row_);
  }

  std::string_view own_rows(std::uint32_t count) {
    const std::string_view left = std::string_view(delta_.rows()).substr(used_);
    if (left.size() < count * row_) mesh_damaged("a delta lacks rows");
    used_ += count * row_;
    return left.substr(0, count * row_);
  }

  void repeat(std::uint32_t count) {
    const std::string_view row = own_rows(1);
    for (std::uint32_t k = 0; k < count; ++k) out_ += row;
  }

  void count_up(std::uint32_t count, std::int64_t start) {
    if (shape_.components != 1) mesh_damaged("a delta counts in an array of several columns");
    const std::uint64_t first = next_row() + static_cast<std::uint64_t>(start);
    switch (shape_.type) {
      case remesh::v1::ARRAY_TYPE_I32:
        return count_from<std::int32_t>(static_cast<std::int64_t>(first), count);
      case remesh::v1::ARRAY_TYPE_U8:
        return count_from<std::uint8_t>(static_cast<std::int64_t>(first), count);
      case remesh::v1::ARRAY_TYPE_U64:
        return count_from<std::uint64_t>(first, count);
      default:
        mesh_damaged("a delta counts in an array that is not of whole numbers");
    }
  }

  template <class Number, class Wide>
  void count_from(Wide first, std::uint32_t count) {
    constexpr Wide kLowest = std::numeric_limits<Number>::min();
    constexpr Wide kHighest = std::numeric_limits<Number>::max();
    if (first < kLowest || first > kHighest ||
        count - 1 > static_cast<std::uint64_t>(kHighest - first))
      mesh_damaged("a delta counts too far");
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto number = static_cast<Number>(first + static_cast<Wide>(k));
      out_.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
  }

  const ArrayDelta& delta_;
  ArrayShape shape_;
  std::size_t row_;
  std::string_view base_;
  std::size_t used_ = 0;  ///< of the delta's own rows, bytes
  std::string out_;
};

}  // namespace

std::string apply_delta(const ArrayDelta& delta, const ArrayShape& shape, std::uint32_t count,
                        std::string_view base) {
  return Rebuilder(delta, shape, base).rebuild(count);
}

}  // namespace remeshd::client
