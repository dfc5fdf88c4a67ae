#pragma once

namespace remeshd {

/// A generated service of which the methods given take and give raw bytes: gRPC's
/// WithRawCallbackMethod_... on top of each other.
template <typename Service, template <typename> typename... Methods>
struct RawMethods {
  using Type = Service;
};
template <typename Service, template <typename> typename First,
          template <typename> typename... Others>
struct RawMethods<Service, First, Others...> {
  using Type = typename RawMethods<First<Service>, Others...>::Type;
};

}  // namespace remeshd
