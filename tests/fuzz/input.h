#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace remeshd::fuzz {

/// The bytes of one run, taken from front to back. What is no more there reads as zero, or empty.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size)
      : bytes_(reinterpret_cast<const char*>(data), size) {}

  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  std::uint8_t byte() { return static_cast<std::uint8_t>(number(1)); }
  /// Little-endian, of `size` bytes.
  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    const std::string_view taken = take(size);
    for (std::size_t k = 0; k < taken.size(); ++k)
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(taken[k])) << (8 * k);
    return value;
  }
  std::string_view take(std::size_t size) {
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(taken.size());
    return taken;
  }
  std::string_view rest() { return take(bytes_.size()); }
  /// Up to the next separator, which is taken too.
  std::string_view until(char separator) {
    const std::size_t end = std::min(bytes_.find(separator), bytes_.size());
    const std::string_view taken = take(end);
    take(1);
    return taken;
  }

 private:
  std::string_view bytes_;
};

}  // namespace remeshd::fuzz
