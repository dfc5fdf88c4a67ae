#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace remeshd {

/// The value of an option, whichever way it came.
using OptionValue = std::variant<bool, std::int64_t, double, std::string, std::vector<std::string>>;

/// Which alternative of OptionValue an option has.
enum class OptionKind : std::uint8_t { Switch, Whole, Number, Text, List };

[[nodiscard]] inline OptionKind kind_of(const OptionValue& value) {
  return static_cast<OptionKind>(value.index());
}

/// `a whole number`, as a message names it.
std::string_view name_of(OptionKind kind);

/// Reads the text of a flag or of an environment variable. A list's elements have commas between.
/// Throws ConfigError where the text is no value of this kind.
OptionValue parse_option_value(OptionKind kind, const std::string& text);

/// As a TOML file has it: `"a text"`, `12`, `0.5`, `true`, `["a", "b"]`.
std::string to_toml(const OptionValue& value);

}  // namespace remeshd
