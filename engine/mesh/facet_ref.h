#pragma once

#include <compare>
#include <cstdint>

namespace remeshd {

/// A facet of a mesh, as a tet and the corner opposite to it. Or none; or, in a patch of a mesh, a
/// facet of a tet beyond the patch's boundary, by a number from 0.
///
/// Stored as one integer: 4 * tet + corner; -1 for none; -2 - k for number k beyond.
class FacetRef {
 public:
  FacetRef() = default;  ///< uninitialised, as an int would be
  constexpr FacetRef(std::int32_t tet, int corner) : code_(4 * tet + corner) {}
  static constexpr FacetRef none() { return FacetRef(-1); }
  static constexpr FacetRef beyond(std::int32_t k) { return FacetRef(-2 - k); }

  [[nodiscard]] constexpr bool is_tet() const { return code_ >= 0; }
  [[nodiscard]] constexpr bool is_none() const { return code_ == -1; }
  [[nodiscard]] constexpr bool is_beyond() const { return code_ < -1; }
  /// Negative unless is_tet().
  [[nodiscard]] constexpr std::int32_t tet() const { return code_ >> 2; }
  [[nodiscard]] constexpr int corner() const { return code_ & 3; }
  /// Pre: is_beyond().
  [[nodiscard]] constexpr std::int32_t exterior() const { return -2 - code_; }
  [[nodiscard]] constexpr std::int32_t code() const { return code_; }

  friend constexpr bool operator==(FacetRef, FacetRef) = default;
  friend constexpr auto operator<=>(FacetRef a, FacetRef b) { return a.code_ <=> b.code_; }
  template <class A>
  void serialize(A& archive) {
    archive(code_);
  }

 private:
  explicit constexpr FacetRef(std::int32_t code) : code_(code) {}

  std::int32_t code_;
};

}  // namespace remeshd
