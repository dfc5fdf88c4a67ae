#include "server/config/option_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "server/config/config_error.h"

namespace remeshd {
namespace {

using Numbers = std::numeric_limits<std::int64_t>;

// Each takes the member that it sets as a function `Settings& -> Member&`.

template <typename Member>
OptionValue read(Member member, const Settings& settings) {
  return member(const_cast<Settings&>(settings));  // `member` only names a place
}

template <typename Member>
Option text(std::string name, std::string argument, Member member, std::string help) {
  return {.name = std::move(name),
          .kind = OptionKind::Text,
          .argument = std::move(argument),
          .help = std::move(help),
          .set = [member](Settings& to,
                          const OptionValue& value) { member(to) = std::get<std::string>(value); },
          .get = [member](const Settings& from) -> OptionValue {
            return std::string(member(const_cast<Settings&>(from)));
          }};
}

template <typename Member>
Option choice(std::string name, std::vector<std::string> words, Member member, std::string help) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  Option option = text(std::move(name), "WORD", member, help + ": " + all);
  option.set = [member, words = std::move(words), all](Settings& to, const OptionValue& value) {
    const auto& word = std::get<std::string>(value);
    if (std::find(words.begin(), words.end(), word) == words.end())
      throw ConfigError(fmt::format("`{}` is none of: {}", word, all));
    member(to) = word;
  };
  return option;
}

template <typename Member>
Option list(std::string name, std::string argument, Member member, std::string help) {
  return {.name = std::move(name),
          .kind = OptionKind::List,
          .argument = std::move(argument),
          .help = std::move(help),
          .set =
              [member](Settings& to, const OptionValue& value) {
                member(to) = std::get<std::vector<std::string>>(value);
              },
          .get = [member](const Settings& from) { return read(member, from); }};
}

struct Range {
  std::int64_t least = 0, most = Numbers::max();
};

template <typename Member>
Option whole(std::string name, Range range, Member member, std::string help) {
  return {.name = std::move(name),
          .kind = OptionKind::Whole,
          .argument = "N",
          .help = std::move(help),
          .set =
              [member, range](Settings& to, const OptionValue& value) {
                const auto number = std::get<std::int64_t>(value);
                if (number < range.least)
                  throw ConfigError(fmt::format("{} is less than {}", number, range.least));
                if (number > range.most)
                  throw ConfigError(fmt::format("{} is more than {}", number, range.most));
                auto& place = member(to);
                place = static_cast<std::remove_reference_t<decltype(place)>>(number);
              },
          .get = [member](const Settings& from) -> OptionValue {
            return static_cast<std::int64_t>(member(const_cast<Settings&>(from)));
          }};
}

template <typename Member>
Option mebibytes(std::string name, Member member, std::string help) {
  Option option = whole(std::move(name), {1, Numbers::max() >> 20U}, member, std::move(help));
  option.argument = "MIB";
  option.set = [set = option.set, member](Settings& to, const OptionValue& value) {
    set(to, value);
    member(to) <<= 20U;
  };
  option.get = [member](const Settings& from) -> OptionValue {
    return static_cast<std::int64_t>(member(const_cast<Settings&>(from)) >> 20U);
  };
  return option;
}

template <typename Member>
Option seconds(std::string name, double least, Member member, std::string help) {
  return {.name = std::move(name),
          .kind = OptionKind::Number,
          .argument = "SECONDS",
          .help = std::move(help),
          .set =
              [member, least](Settings& to, const OptionValue& value) {
                constexpr double kYear = 366 * 86400.0;  // what is longer overflows clocks
                const double number = std::get<double>(value);
                if (number < least)
                  throw ConfigError(fmt::format("{} is less than {}", number, least));
                if (number > kYear)
                  throw ConfigError(fmt::format("{} is more than a year", number));
                member(to) = number;
              },
          .get = [member](const Settings& from) { return read(member, from); }};
}

std::vector<Option> make_table() {
  using S = Settings;
  return {
      list(
          "listen", "ADDRESS", [](S & s) -> auto& { return s.daemon.listen; },
          "HOST:PORT to serve on; port 0 takes a free one; or unix:/PATH, a Unix socket; may be "
          "given several times"),
      whole(
          "max-connections", {1, 1000000}, [](S & s) -> auto& { return s.daemon.max_connections; },
          "connections at a time"),
      text(
          "store", "FOLDER", [](S & s) -> auto& { return s.daemon.store; },
          "folder that keeps the revisions; without it they live in memory only"),
      whole(
          "workers", {0, 1024}, [](S & s) -> auto& { return s.daemon.workers; },
          "computations at a time; 0: one per processor"),
      whole(
          "threads", {0, 1024}, [](S & s) -> auto& { return s.daemon.threads; },
          "most threads of one computation; 0: one per processor"),
      whole(
          "queue", {0, 1000000}, [](S & s) -> auto& { return s.daemon.queue; },
          "computations that may wait for a worker"),
      seconds(
          "queue-wait", 0.001, [](S & s) -> auto& { return s.daemon.queue_wait; },
          "that one may wait"),
      seconds(
          "compute-limit", 0, [](S & s) -> auto& { return s.daemon.compute_limit; },
          "that one computation may take; 0: any"),
      mebibytes(
          "memory", [](S & s) -> auto& { return s.daemon.memory; },
          "MiB that computations, loads and revisions in memory may take"),
      mebibytes(
          "cache", [](S & s) -> auto& { return s.daemon.cache; },
          "MiB of the memory that revisions held for later requests may take"),
      whole(
          "max-nodes", {20, 5000000}, [](S & s) -> auto& { return s.daemon.max_nodes; },
          "most nodes that a request may ask for"),
      text(
          "dumps", "FOLDER", [](S & s) -> auto& { return s.daemon.dumps; },
          "folder in which every computation leaves its stages, for debugging"),
      choice(
          "log-level", {"trace", "debug", "info", "warning", "error", "off"},
          [](S & s) -> auto& { return s.log_level; }, "least important lines that are logged"),
      text(
          "log-file", "FILE", [](S & s) -> auto& { return s.log_file; },
          "file to append the log to, instead of stderr"),
  };
}

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

}  // namespace

std::string Option::key() const {
  std::string out;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] != '-') {
      out += name[i];
    } else if (++i < name.size()) {
      out += upper(name.substr(i, 1));
    }
  }
  return out;
}

std::string Option::snake_key() const {
  std::string out = name;
  std::replace(out.begin(), out.end(), '-', '_');
  return out;
}

std::string Option::variable() const { return "REMESHD_" + upper(snake_key()); }

const std::vector<Option>& option_table() {
  static const std::vector<Option> table = make_table();
  return table;
}

std::vector<std::string> option_names(std::string (Option::*name)() const) {
  std::vector<std::string> names;
  for (const Option& option : option_table()) names.push_back((option.*name)());
  return names;
}

}  // namespace remeshd
