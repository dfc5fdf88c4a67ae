#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "server/store/files.h"
#include "server/store/records.h"

namespace remeshd {

/// The transactions of a store in their order, one a line: CRC-32C, a space, JSON. A transaction is
/// in the store once its line is on the disk.
class Journal {
 public:
  /// Opens or makes the file; cuts off an unfinished last line, which is what a crash leaves.
  explicit Journal(std::filesystem::path file);

  /// Throws Error(StoreFailed, StoreFull); the journal is then as before.
  void append(const Transaction& transaction);
  /// Calls `visit` for each whole line from byte `from` on, which must be a line's start. Lines
  /// whose checksum is wrong are left out. Returns how many.
  std::uint64_t replay(std::uint64_t from,
                       const std::function<void(const Transaction&)>& visit) const;

  [[nodiscard]] std::uint64_t size() const { return size_; }  ///< bytes
  /// Checksum of the last line that ends at or before `end` (0 for none): tells whether an index
  /// was made from this journal.
  [[nodiscard]] std::uint32_t mark(std::uint64_t end) const;

 private:
  std::filesystem::path file_;
  File out_;
  std::uint64_t size_ = 0;
  std::uint32_t last_mark_ = 0;
  bool torn_ = false;  ///< bytes beyond `size_` may stand in the file
};

}  // namespace remeshd
