#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace remeshd {

/// Why something could not be done; the caller takes another way, the last of which is a fuse of
/// the whole model by the CAD kernel.
struct GaveUp {
  const char* file = "";  ///< source file that gave up, without folder and extension: `slabs`
  const char* why = "";   ///< half a sentence: `two heights are neither clearly the same nor ...`
};

/// `slabs: two heights are neither clearly the same nor clearly apart`
inline std::string text_of(const GaveUp& gave_up) {
  return std::string(gave_up.file) + ": " + gave_up.why;
}

/// A value, or why there is none: as std::optional, but with a reason.
template <typename T>
class Tried {
 public:
  Tried(T value) : result_(std::move(value)) {}
  Tried(const GaveUp& why) : result_(why) {}

  explicit operator bool() const { return std::holds_alternative<T>(result_); }

  // Pre: there is a value.
  T& operator*() & { return std::get<T>(result_); }
  const T& operator*() const& { return std::get<T>(result_); }
  T&& operator*() && { return std::get<T>(std::move(result_)); }
  T* operator->() { return &std::get<T>(result_); }
  const T* operator->() const { return &std::get<T>(result_); }

  /// Pre: there is no value.
  [[nodiscard]] const GaveUp& why() const { return std::get<GaveUp>(result_); }

 private:
  std::variant<T, GaveUp> result_;
};

/// Whether something was done, or why not.
template <>
class [[nodiscard]] Tried<void> {
 public:
  Tried() = default;  ///< done
  Tried(const GaveUp& why) : why_(why) {}

  explicit operator bool() const { return !why_; }

  /// Pre: it was not done.
  [[nodiscard]] const GaveUp& why() const { return why_.value(); }

 private:
  std::optional<GaveUp> why_;
};

}  // namespace remeshd
