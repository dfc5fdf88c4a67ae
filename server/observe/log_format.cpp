#include <spdlog/pattern_formatter.h>

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "server/observe/log_sink.h"

namespace remeshd {
namespace {

using nlohmann::ordered_json;

std::string_view text_of(spdlog::string_view_t text) { return {text.data(), text.size()}; }

class TextFormat final : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) override {
    std::string clean(text_of(message.payload));
    for (char& c : clean)
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '_';
    spdlog::details::log_msg line(message);
    line.payload = clean;
    pattern_.format(line, out);
  }
  [[nodiscard]] std::unique_ptr<formatter> clone() const override {
    return std::make_unique<TextFormat>();
  }

 private:
  spdlog::pattern_formatter pattern_{"%Y-%m-%dT%H:%M:%S.%e%z %l %v"};
};

struct Field {
  std::string_view name, value;
};

/// The fields of a message of `name=value` words alone; nothing for any other message.
std::optional<std::vector<Field>> fields_of(std::string_view message) {
  std::vector<Field> fields;
  while (!message.empty()) {
    const std::string_view word = message.substr(0, message.find(' '));
    message.remove_prefix(std::min(word.size() + 1, message.size()));
    const std::size_t equals = word.find('=');
    if (equals == word.npos || equals == 0) return std::nullopt;
    const std::string_view name = word.substr(0, equals);
    if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") != name.npos) return std::nullopt;
    fields.push_back({name, word.substr(equals + 1)});
  }
  return fields;
}

/// Which fields are numbers goes by their names: a client may choose a number for the id of its
/// request, which is text.
ordered_json value_of(const Field& field) {
  constexpr std::array<std::string_view, 4> kNumbers{"call", "ms", "answered", "failed"};
  double number = 0;
  const char* const end = field.value.data() + field.value.size();
  if (std::find(kNumbers.begin(), kNumbers.end(), field.name) != kNumbers.end()) {
    const auto [rest, failure] = std::from_chars(field.value.data(), end, number);
    if (failure == std::errc() && rest == end && std::isfinite(number)) {
      if (number == std::floor(number) && number < 1e15) return static_cast<std::int64_t>(number);
      return number;
    }
  }
  return std::string(field.value);
}

class JsonFormat final : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) override {
    spdlog::memory_buf_t time;
    time_.format(message, time);
    ordered_json line{{"time", std::string(time.data(), time.size())},
                      {"level", std::string(text_of(spdlog::level::to_string_view(message.level)))},
                      {"message", std::string(text_of(message.payload))}};
    if (const auto fields = fields_of(text_of(message.payload)))
      for (const Field& field : *fields)
        if (!line.contains(field.name)) line[std::string(field.name)] = value_of(field);
    const std::string text =
        line.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + '\n';
    out.append(text.data(), text.data() + text.size());
  }
  [[nodiscard]] std::unique_ptr<formatter> clone() const override {
    return std::make_unique<JsonFormat>();
  }

 private:
  spdlog::pattern_formatter time_{"%Y-%m-%dT%H:%M:%S.%eZ", spdlog::pattern_time_type::utc, ""};
};

}  // namespace

std::unique_ptr<spdlog::formatter> make_text_format() { return std::make_unique<TextFormat>(); }
std::unique_ptr<spdlog::formatter> make_json_format() { return std::make_unique<JsonFormat>(); }

}  // namespace remeshd
