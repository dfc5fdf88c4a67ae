#include "server/store/line_reader.h"

namespace remeshd {
namespace {

constexpr std::size_t kBytesRead = std::size_t{1} << 18;  // bytes read at a time

}  // namespace

std::optional<std::string_view> LineReader::next() {
  std::size_t end = buffer_.find('\n', begin_);
  while (end == std::string::npos) {
    buffer_.erase(0, begin_);
    begin_ = 0;
    const std::size_t known = buffer_.size();
    const std::string piece = file_.read(place_ + known, kBytesRead);
    if (piece.empty()) break;
    buffer_ += piece;
    end = buffer_.find('\n', known);
  }
  end = end == std::string::npos ? buffer_.size() : end + 1;
  if (end == begin_) return std::nullopt;
  const std::string_view line = std::string_view(buffer_).substr(begin_, end - begin_);
  begin_ = end;
  place_ += line.size();
  return line;
}

bool same_content(const File& a, const File& b) {
  for (std::uint64_t start = 0;; start += kBytesRead) {
    const std::string piece = a.read(start, kBytesRead);
    if (piece != b.read(start, kBytesRead)) return false;
    if (piece.size() < kBytesRead) return true;
  }
}

}  // namespace remeshd
