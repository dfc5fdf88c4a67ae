#pragma once

#include <concepts>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

namespace remeshd {

/// A whole number that the type can hold, where nlohmann's own conversion would silently change
/// others. Throws nlohmann::json::exception for anything else.
template <std::integral Number>
Number whole_number(const nlohmann::json& j) {
  if (j.is_number_unsigned()) {
    const auto number = j.get<std::uint64_t>();
    if (std::in_range<Number>(number)) return static_cast<Number>(number);
  } else if (j.is_number_integer()) {
    const auto number = j.get<std::int64_t>();
    if (std::in_range<Number>(number)) return static_cast<Number>(number);
  }
  throw nlohmann::json::type_error::create(302, "not a whole number of this size", &j);
}

/// The same of an object's field, into `out`; `number_or` returns `otherwise` where there is no
/// such field.
template <std::integral Number>
void read_number(const nlohmann::json& object, const char* field, Number& out) {
  out = whole_number<Number>(object.at(field));
}
template <std::integral Number>
Number number_or(const nlohmann::json& object, const char* field, Number otherwise) {
  const auto found = object.find(field);
  return found == object.end() ? otherwise : whole_number<Number>(*found);
}

}  // namespace remeshd
