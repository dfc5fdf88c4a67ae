#pragma once

#include <mutex>

namespace remeshd {

/// A value that is worked out once, when somebody first asks for it, by any thread. A copy starts
/// without it.
template <typename Value>
class Lazy {
 public:
  Lazy() = default;
  Lazy(const Lazy& /*other*/) {}
  Lazy& operator=(const Lazy&) = delete;

  /// The value, by `make` if nobody has asked before. Where that throws, the next call tries again.
  template <typename Make>
  const Value& get(Make&& make) const {
    std::call_once(once_, [&] { value_ = make(); });
    return value_;
  }

 private:
  mutable std::once_flag once_;
  mutable Value value_{};
};

}  // namespace remeshd
