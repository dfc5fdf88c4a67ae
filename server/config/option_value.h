#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace remeshd {

/// The value of an option, from the file, the environment or the arguments.
using OptionValue = std::variant<bool, std::int64_t, double, std::string, std::vector<std::string>>;

/// Which alternative of OptionValue an option has.
enum class OptionKind : std::uint8_t { Switch, Whole, Number, Text, List };

[[nodiscard]] inline OptionKind kind_of(const OptionValue& value) {
  return static_cast<OptionKind>(value.index());
}

/// `a whole number`, as a message names it.
std::string_view name_of(OptionKind kind);

/// Reads the text of a flag or of an environment variable. The elements of a list are separated by
/// commas.
/// Throws ConfigError where the text is no value of this kind.
OptionValue parse_option_value(OptionKind kind, const std::string& text);

/// As a TOML file has it: `"a text"`, `12`, `0.5`, `true`, `["a", "b"]`.
std::string to_toml(const OptionValue& value);

}  // namespace remeshd
