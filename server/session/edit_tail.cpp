#include "server/session/edit_tail.h"

#include <cstdint>

#include "engine/base/error.h"

namespace remeshd {
namespace {

constexpr std::size_t kLengthBytes = 4;  // at the very end, the least significant first

}  // namespace

void append_edit(std::string& bytes, const std::string& edit) {
  bytes.reserve(bytes.size() + edit.size() + kLengthBytes);
  bytes += edit;
  for (std::size_t k = 0; k < kLengthBytes; ++k)
    bytes += static_cast<char>(edit.size() >> (8 * k) & 255U);
}

std::string take_edit(std::string& bytes) {
  std::uint64_t length = 0;
  const std::size_t end = bytes.size() < kLengthBytes ? 0 : bytes.size() - kLengthBytes;
  for (std::size_t k = 0; end > 0 && k < kLengthBytes; ++k)
    length |= std::uint64_t{static_cast<unsigned char>(bytes[end + k])} << (8 * k);
  if (end == 0 || length > end)
    throw error::internal("store", "a stored revision lacks the document of its edit");
  std::string edit = bytes.substr(end - length, length);
  bytes.resize(end - length);
  return edit;
}

}  // namespace remeshd
