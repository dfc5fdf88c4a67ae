#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "server/store/files.h"

namespace remeshd {

/// Reads a file line by line, with no more of it in memory than the longest line needs.
class LineReader {
 public:
  /// `file` must outlive it.
  explicit LineReader(const File& file) : file_(file) {}

  /// The next line with its line break, which the last one may lack; nothing at the end. It is
  /// valid until the next call. Throws Error(STORE_FAILED).
  std::optional<std::string_view> next();
  /// Where in the file the line after the last one returned begins.
  [[nodiscard]] std::uint64_t place() const { return place_; }

 private:
  const File& file_;
  std::string buffer_;
  std::size_t begin_ = 0;    ///< of what was not returned yet, in the buffer
  std::uint64_t place_ = 0;  ///< of the same, in the file
};

/// Whether two files hold the same bytes. Throws Error(STORE_FAILED).
bool same_content(const File& a, const File& b);

}  // namespace remeshd
