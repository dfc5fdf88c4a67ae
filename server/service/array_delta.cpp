#include "server/service/array_delta.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace remeshd {
namespace {

using remesh::v1::ArrayDelta;

// What a run costs beside its rows: kind, count and start as varints.
constexpr std::size_t kRunBytes = 8;
// Shorter rows are not searched for in the base: small numbers recur everywhere.
constexpr std::size_t kLeastBytesToFind = 8;
// Rows without a run before the base is searched: rows that moved come in long runs, and a few new
// ones are not worth a search.
constexpr std::size_t kRowsBeforeSearch = 8;

/// Hash table of rows by their bytes: the index of the first row of these bytes.
class RowIndex {
 public:
  RowIndex(std::string_view rows, std::size_t row)
      : rows_(rows), row_(row), table_(std::bit_ceil(2 * (rows.size() / row) + 1), kNone) {
    for (std::size_t k = 0; k < rows.size() / row; ++k) {
      std::uint32_t& place = table_[place_of(at(k))];
      if (place == kNone) place = static_cast<std::uint32_t>(k);
    }
  }
  /// Nothing where there is no such row.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view row) const {
    const std::uint32_t k = table_[place_of(row)];
    if (k == kNone) return std::nullopt;
    return k;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] std::string_view at(std::size_t k) const { return rows_.substr(k * row_, row_); }
  /// The place of the row, or the free one where it would go.
  [[nodiscard]] std::size_t place_of(std::string_view row) const {
    std::size_t place = std::hash<std::string_view>()(row) & (table_.size() - 1);
    while (table_[place] != kNone && at(table_[place]) != row)
      place = (place + 1) & (table_.size() - 1);
    return place;
  }

  const std::string_view rows_;
  const std::size_t row_;  ///< bytes
  std::vector<std::uint32_t> table_;
};

class Encoder {
 public:
  Encoder(const MeshArray& array, std::string_view bytes, std::string_view base)
      : array_(array),
        row_(bytes.empty() ? 1 : bytes.size() / array.count),
        bytes_(bytes),
        base_(base),
        rows_(bytes.size() / row_),
        base_rows_(base.size() / row_) {}

  ArrayDelta encode() {
    while (at_ < rows_) {
      const Run run = best();
      if (run.rows == 0) {
        ++own_;
        ++at_;
        continue;
      }
      end_own_rows();
      add(run.kind, run.rows, run.start);
      if (run.kind == ArrayDelta::KIND_REPEAT) delta_.mutable_rows()->append(row(bytes_, at_));
      if (run.kind == ArrayDelta::KIND_COPY) shift_ = run.start;
      at_ += run.rows;
    }
    end_own_rows();
    return std::move(delta_);
  }

 private:
  struct Run {
    ArrayDelta::Kind kind = ArrayDelta::KIND_UNSPECIFIED;
    std::size_t rows = 0;
    std::int64_t start = 0;
  };

  [[nodiscard]] std::string_view row(std::string_view rows, std::size_t k) const {
    return rows.substr(k * row_, row_);
  }

  /// The run that covers most rows from `at_` on; an empty one where it would take more bytes than
  /// the rows themselves.
  Run best() {
    Run best = copy(shift_);
    const auto take = [&](const Run& other) {
      if (other.rows > best.rows) best = other;
    };
    if (shift_ != 0) take(copy(0));
    take(repeat());
    take(count_up());
    if (worth(best)) return best;
    if (own_ < kRowsBeforeSearch) return {};
    best = found();
    return worth(best) ? best : Run{};
  }

  [[nodiscard]] bool worth(const Run& run) const {
    const std::size_t told = run.kind == ArrayDelta::KIND_REPEAT ? 1 : 0;
    return run.rows > told && (run.rows - told) * row_ > kRunBytes;
  }

  /// The run of rows that equal the base's rows `shift` further on.
  [[nodiscard]] Run copy(std::int64_t shift) const {
    const std::int64_t from = static_cast<std::int64_t>(at_) + shift;
    if (from < 0 || static_cast<std::size_t>(from) >= base_rows_) return {};
    const char* now = bytes_.data() + at_ * row_;
    const char* then = base_.data() + static_cast<std::size_t>(from) * row_;
    const std::size_t most =
        std::min(rows_ - at_, base_rows_ - static_cast<std::size_t>(from)) * row_;
    constexpr std::size_t kStep = 512;
    std::size_t same = 0;
    while (same + kStep <= most && std::memcmp(now + same, then + same, kStep) == 0) same += kStep;
    while (same + row_ <= most &&
           std::memcmp(now + same / row_ * row_, then + same / row_ * row_, row_) == 0)
      same = (same / row_ + 1) * row_;
    return {ArrayDelta::KIND_COPY, same / row_, shift};
  }

  [[nodiscard]] Run repeat() const {
    const std::string_view first = row(bytes_, at_);
    std::size_t end = at_ + 1;
    while (end < rows_ && row(bytes_, end) == first) ++end;
    return {ArrayDelta::KIND_REPEAT, end - at_, 0};
  }

  [[nodiscard]] Run count_up() const {
    if (array_.components != 1) return {};
    if (array_.type != NumberType::I32 && array_.type != NumberType::U64 &&
        array_.type != NumberType::U8)
      return {};
    const std::uint64_t first = number(at_);
    // Not beyond the largest number of 64 bits.
    const bool may_wrap = array_.type == NumberType::U64;
    const std::uint64_t most = may_wrap ? std::numeric_limits<std::uint64_t>::max() - first : rows_;
    std::size_t end = at_ + 1;
    while (end < rows_ && end - at_ <= most && number(end) == first + (end - at_)) ++end;
    return {ArrayDelta::KIND_COUNT, end - at_, static_cast<std::int64_t>(first - at_)};
  }

  [[nodiscard]] std::uint64_t number(std::size_t k) const {
    const char* at = bytes_.data() + k * row_;
    if (array_.type == NumberType::U8) return static_cast<std::uint8_t>(*at);
    if (array_.type == NumberType::U64) {
      std::uint64_t value = 0;
      std::memcpy(&value, at, sizeof value);
      return value;
    }
    std::int32_t value = 0;
    std::memcpy(&value, at, sizeof value);
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
  }

  /// A copy from where the base has the row at `at_`; empty where it has not.
  Run found() {
    if (row_ < kLeastBytesToFind || base_rows_ == 0) return {};
    if (!index_) index_.emplace(base_, row_);
    const auto from = index_->find(row(bytes_, at_));
    if (!from) return {};
    return copy(static_cast<std::int64_t>(*from) - static_cast<std::int64_t>(at_));
  }

  void add(ArrayDelta::Kind kind, std::size_t rows, std::int64_t start) {
    delta_.add_kinds(kind);
    delta_.add_counts(static_cast<std::uint32_t>(rows));
    delta_.add_starts(start);
  }

  void end_own_rows() {
    if (own_ == 0) return;
    add(ArrayDelta::KIND_ROWS, own_, 0);
    delta_.mutable_rows()->append(bytes_.substr((at_ - own_) * row_, own_ * row_));
    own_ = 0;
  }

  const MeshArray& array_;
  const std::size_t row_;  ///< bytes
  const std::string_view bytes_, base_;
  const std::size_t rows_, base_rows_;
  std::optional<RowIndex> index_;  ///< of the base, once needed
  std::size_t at_ = 0;
  std::size_t own_ = 0;     ///< rows before `at_` that no run covers, not written yet
  std::int64_t shift_ = 0;  ///< of the last copy
  ArrayDelta delta_;
};

}  // namespace

ArrayDelta delta_of(const MeshArray& array, std::string_view bytes, std::string_view base) {
  return Encoder(array, bytes, base).encode();
}

}  // namespace remeshd
