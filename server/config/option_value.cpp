#include "server/config/option_value.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "server/config/config_error.h"

namespace remeshd {
namespace {

template <typename Number>
std::optional<Number> number_of(const std::string& text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, number);
  if (failure != std::errc() || rest != end) return std::nullopt;
  return number;
}

std::optional<bool> switch_of(const std::string& text) {
  for (const char* yes : {"true", "yes", "on", "1"})
    if (text == yes) return true;
  for (const char* no : {"false", "no", "off", "0"})
    if (text == no) return false;
  return std::nullopt;
}

std::vector<std::string> list_of(const std::string& text) {
  std::vector<std::string> list;
  std::size_t begin = 0;
  while (true) {
    const std::size_t comma = text.find(',', begin);
    list.push_back(text.substr(begin, comma - begin));
    if (comma == std::string::npos) return list;
    begin = comma + 1;
  }
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      out += fmt::format("\\u{:04X}", byte);
    } else {
      out += c;
    }
  }
  return out + '"';
}

struct ToToml {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const {
    // The shortest text that reads back to the same number; a whole one needs its point in TOML.
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
  }
  std::string operator()(const std::string& value) const { return quoted(value); }
  std::string operator()(const std::vector<std::string>& value) const {
    std::string out = "[";
    for (const std::string& element : value) out += (out.size() > 1 ? ", " : "") + quoted(element);
    return out + ']';
  }
};

}  // namespace

std::string_view name_of(OptionKind kind) {
  static constexpr std::string_view kNames[] = {"true or false", "a whole number", "a number",
                                                "a text", "a list of texts"};
  return kNames[static_cast<std::size_t>(kind)];
}

OptionValue parse_option_value(OptionKind kind, const std::string& text) {
  switch (kind) {
    case OptionKind::Switch:
      if (const auto value = switch_of(text)) return *value;
      break;
    case OptionKind::Whole:
      if (const auto value = number_of<std::int64_t>(text)) return *value;
      break;
    case OptionKind::Number:
      if (const auto value = number_of<double>(text); value && std::isfinite(*value)) return *value;
      break;
    case OptionKind::Text:
      return text;
    case OptionKind::List:
      return list_of(text);
  }
  throw ConfigError(fmt::format("`{}` is not {}", text, name_of(kind)));
}

std::string to_toml(const OptionValue& value) { return std::visit(ToToml(), value); }

}  // namespace remeshd
