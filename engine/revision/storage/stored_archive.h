#pragma once

#include <bit>
#include <cereal/archives/portable_binary.hpp>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "engine/base/error.h"

namespace remeshd {

/// Reads what cereal's portable binary archive wrote on a little-endian machine. Whatever the
/// bytes, the memory it takes is bounded by a multiple of their number: a list with more elements
/// than bytes that follow is refused.
///
/// Throws Error(Internal) where the bytes end too soon or cannot have been written so.
template <class Archive>
class StoredArchive : public cereal::InputArchive<Archive, cereal::AllowEmptyClassElision> {
 public:
  explicit StoredArchive(Archive* archive, std::string_view bytes)
      : cereal::InputArchive<Archive, cereal::AllowEmptyClassElision>(archive), rest_(bytes) {
    std::uint8_t little_endian = 0;
    take(&little_endian, 1);
    if (little_endian != 1 || std::endian::native != std::endian::little)
      throw error::internal("store", "a revision of another machine");
  }
  void take(void* to, std::size_t size) {
    if (size > rest_.size()) throw error::internal("store", "a stored revision is cut off");
    if (size > 0) std::memcpy(to, rest_.data(), size);
    rest_.remove_prefix(size);
  }
  void take_size(cereal::size_type& size) {
    take(&size, sizeof size);
    if (size > rest_.size()) throw error::internal("store", "a stored list is cut off");
  }
  void take_switch(bool& value) {
    std::uint8_t byte = 0;
    take(&byte, 1);
    if (byte > 1) throw error::internal("store", "a stored switch is neither on nor off");
    value = byte == 1;
  }

 private:
  std::string_view rest_;
};

template <class A>
concept ReadsStored = std::is_base_of_v<StoredArchive<A>, A>;

// What cereal asks of an archive.

template <ReadsStored A, class T>
requires std::is_arithmetic_v<T>
void load(A& a, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    a.take_switch(value);
  } else {
    a.take(&value, sizeof value);
  }
}
template <ReadsStored A, class T>
void load(A& a, cereal::NameValuePair<T>& pair) {
  a(pair.value);
}
template <ReadsStored A, class T>
void load(A& a, cereal::SizeTag<T>& tag) {
  a.take_size(tag.size);
}
template <ReadsStored A, class T>
void load(A& a, cereal::BinaryData<T>& data) {
  a.take(data.data, data.size);
}

}  // namespace remeshd
