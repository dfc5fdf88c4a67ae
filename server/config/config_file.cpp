#include "server/config/config_file.h"

#include <fmt/format.h>
// toml++ is compiled into this file alone, so that no library of it is needed.
#define TOML_HEADER_ONLY 1
// Some assertions of toml++ fail at text that is merely wrong, such as `[%`; the code after them
// refuses it.
#define TOML_ASSERT(condition) static_assert(true)
#include <toml++/toml.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <optional>

#include "engine/base/text/nearest_name.h"
#include "engine/base/utf8.h"
#include "server/config/ascii_form.h"
#include "server/config/config_error.h"
#include "server/limits.h"

namespace remeshd {
namespace {

const Option* find_option(std::string_view key) {
  for (const Option& option : option_table())
    if (key == option.key() || key == option.snake_key()) return &option;
  return nullptr;
}

std::optional<std::string> text_of(const toml::node& node, const AsciiForm& form) {
  const auto text = node.value_exact<std::string>();
  return text ? std::optional(form.original(*text)) : std::nullopt;
}

std::optional<std::vector<std::string>> list_of(const toml::node& node, const AsciiForm& form) {
  std::vector<std::string> list;
  if (const auto* array = node.as_array()) {
    for (const toml::node& element : *array) {
      const auto text = text_of(element, form);
      if (!text) return std::nullopt;
      list.push_back(*text);
    }
    return list;
  }
  // One element needs no brackets.
  if (const auto text = text_of(node, form)) return std::vector{*text};
  return std::nullopt;
}

template <typename Value>
std::optional<OptionValue> exact(const toml::node& node) {
  if (const auto value = node.value_exact<Value>()) return OptionValue(*value);
  return std::nullopt;
}

std::optional<OptionValue> value_of(const toml::node& node, const AsciiForm& form,
                                    OptionKind kind) {
  switch (kind) {
    case OptionKind::Switch:
      return exact<bool>(node);
    case OptionKind::Whole:
      return exact<std::int64_t>(node);
    case OptionKind::Number:
      // `5` is a number too. TOML's `inf` and `nan` are none that an option could have.
      if (const auto value = node.value<double>();
          value && node.is_number() && std::isfinite(*value))
        return OptionValue(*value);
      return std::nullopt;
    case OptionKind::Text:
      if (auto text = text_of(node, form)) return OptionValue(*std::move(text));
      return std::nullopt;
    case OptionKind::List:
      if (auto list = list_of(node, form)) return OptionValue(std::move(*list));
      return std::nullopt;
  }
  return std::nullopt;
}

void check_utf8(std::string_view text, const std::string& name) {
  for (std::size_t line = 1, start = 0; start < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    if (!is_utf8(text.substr(start, end - start)))
      throw ConfigError(fmt::format("{}:{}: the line is not UTF-8", name, line));
    start = end + 1;
  }
}

toml::table parse(const AsciiForm& form, const std::string& name) {
  try {
    return toml::parse(form.text(), name);
  } catch (const toml::parse_error& failure) {
    throw ConfigError(fmt::format("{}:{}: {}", name, failure.source().begin.line,
                                  form.original(failure.description())));
  }
}

}  // namespace

std::vector<GivenOption> read_config_text(std::string_view text, const std::string& name) {
  check_utf8(text, name);
  const AsciiForm form(text);
  const toml::table table = parse(form, name);
  std::vector<GivenOption> out;
  for (const auto& [key, node] : table) {
    const std::string word = form.original(key.str());
    const std::string place = fmt::format("{}:{}: {}", name, key.source().begin.line, word);
    const Option* const option = find_option(word);
    if (option == nullptr)
      throw ConfigError(place + " is unknown" + suggestion(word, option_names(&Option::key)));
    if (std::any_of(out.begin(), out.end(),
                    [option](const GivenOption& given) { return given.option == option; }))
      throw ConfigError(fmt::format("{} is given twice: as `{}` and as `{}`", place, option->key(),
                                    option->snake_key()));
    auto value = value_of(node, form, option->kind);
    if (!value) throw ConfigError(fmt::format("{} is to be {}", place, name_of(option->kind)));
    out.push_back({option, std::move(*value), place});
  }
  return out;
}

std::vector<GivenOption> read_config_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(limits::kConfigFileBytes + 1, '\0');
  if (!in) throw ConfigError(fmt::format("{}: {}", file.string(), std::strerror(errno)));
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) throw ConfigError(fmt::format("{}: cannot be read", file.string()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > limits::kConfigFileBytes)
    throw ConfigError(
        fmt::format("{}: has more than {} bytes", file.string(), limits::kConfigFileBytes));
  return read_config_text(text, file.string());
}

}  // namespace remeshd
