#include "server/config/option_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "server/config/config_error.h"

namespace remeshd {
namespace {

using Numbers = std::numeric_limits<std::int64_t>;

// The functions below make one option each. `member`, a function `Settings& -> Member*`, tells
// which member of Settings it sets.

template <typename Member>
OptionValue read(Member member, const Settings& settings) {
  return *member(const_cast<Settings&>(settings));  // `member` only names a place
}

template <typename Member>
Option text(std::string name, std::string argument, Member member, std::string help) {
  return {.name = std::move(name),
          .kind = OptionKind::Text,
          .argument = std::move(argument),
          .help = std::move(help),
          .set = [member](Settings& to,
                          const OptionValue& value) { *member(to) = std::get<std::string>(value); },
          .get = [member](const Settings& from) -> OptionValue {
            return std::string(*member(const_cast<Settings&>(from)));
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
    *member(to) = word;
  };
  return option;
}

template <typename Member>
Option on_off(std::string name, Member member, std::string help) {
  return {.name = std::move(name),
          .kind = OptionKind::Switch,
          .argument = {},
          .help = std::move(help),
          .set = [member](Settings& to,
                          const OptionValue& value) { *member(to) = std::get<bool>(value); },
          .get = [member](const Settings& from) { return read(member, from); }};
}

template <typename Member>
Option list(std::string name, std::string argument, Member member, std::string help) {
  return {.name = std::move(name),
          .kind = OptionKind::List,
          .argument = std::move(argument),
          .help = std::move(help),
          .set =
              [member](Settings& to, const OptionValue& value) {
                *member(to) = std::get<std::vector<std::string>>(value);
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
                auto& place = *member(to);
                place = static_cast<std::remove_reference_t<decltype(place)>>(number);
              },
          .get = [member](const Settings& from) -> OptionValue {
            return static_cast<std::int64_t>(*member(const_cast<Settings&>(from)));
          }};
}

template <typename Member>
Option mebibytes(std::string name, std::int64_t least, Member member, std::string help) {
  Option option = whole(std::move(name), {least, Numbers::max() >> 20U}, member, std::move(help));
  option.argument = "MIB";
  option.set = [set = option.set, member](Settings& to, const OptionValue& value) {
    set(to, value);
    *member(to) <<= 20U;
  };
  option.get = [member](const Settings& from) -> OptionValue {
    return static_cast<std::int64_t>(*member(const_cast<Settings&>(from)) >> 20U);
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
                *member(to) = number;
              },
          .get = [member](const Settings& from) { return read(member, from); }};
}

using S = Settings;

/// Who reaches the daemon, and how.
std::vector<Option> reach_options() {
  return {
      list(
          "listen", "ADDRESS", [](S& s) { return &s.daemon.listen; },
          "HOST:PORT to serve on; port 0 takes a free one; or unix:/PATH, a Unix socket; may be "
          "given several times"),
      text(
          "tls-cert", "FILE", [](S& s) { return &s.daemon.tls.certificate; },
          "certificate in PEM, with its chain: TLS on every address but Unix sockets"),
      text(
          "tls-key", "FILE", [](S& s) { return &s.daemon.tls.key; }, "its key in PEM"),
      text(
          "tls-client-ca", "FILE", [](S& s) { return &s.daemon.tls.client_ca; },
          "certificates in PEM of who signs the clients': each client has to show one"),
      text(
          "token-file", "FILE", [](S& s) { return &s.token_file; },
          "lines `TENANT TOKEN`: each call has to bring one of the tokens; read anew on SIGHUP"),
      on_off(
          "reflection", [](S& s) { return &s.daemon.reflection; },
          "let anyone ask for the protocol (gRPC reflection)"),
      on_off(
          "behind-proxy", [](S& s) { return &s.behind_proxy; },
          "serve addresses that other machines reach without mutual TLS: right only where a "
          "maintained proxy alone can reach them"),
      text(
          "metrics", "HOST:PORT", [](S& s) { return &s.metrics; },
          "serve metrics for Prometheus here, under /metrics"),
      on_off(
          "insecure-metrics", [](S& s) { return &s.insecure_metrics; },
          "serve metrics on an address that other machines reach: whoever does may read them"),
      text(
          "health-socket", "PATH", [](S& s) { return &s.health_socket; },
          "Unix socket to listen on too, for --health"),
      text(
          "port-file", "FILE", [](S& s) { return &s.port_file; },
          "file that tells the addresses, one a line, while the daemon serves"),
      seconds(
          "grace", 0, [](S& s) { return &s.grace; },
          "that requests may go on after SIGTERM or SIGINT"),
      whole(
          "max-connections", {1, 1000000}, [](S& s) { return &s.daemon.max_connections; },
          "connections at a time"),
  };
}

/// What it works with, and how much of it.
std::vector<Option> work_options() {
  return {
      text(
          "store", "FOLDER", [](S& s) { return &s.daemon.store; },
          "folder that keeps the revisions; without it they live in memory only"),
      whole(
          "workers", {0, 1024}, [](S& s) { return &s.daemon.workers; },
          "computations at a time; 0: one per processor"),
      whole(
          "threads", {0, 1024}, [](S& s) { return &s.daemon.threads; },
          "most threads of one computation; 0: one per processor"),
      whole(
          "queue", {0, 1000000}, [](S& s) { return &s.daemon.queue; },
          "computations that may wait for a worker"),
      seconds(
          "queue-wait", 0.001, [](S& s) { return &s.daemon.queue_wait; }, "that one may wait"),
      seconds(
          "compute-limit", 0, [](S& s) { return &s.daemon.compute_limit; },
          "that one computation may take; 0: any"),
      mebibytes(
          "memory", 1, [](S& s) { return &s.daemon.memory; },
          "MiB that computations, loads and revisions in memory may take"),
      mebibytes(
          "cache", 1, [](S& s) { return &s.daemon.cache; },
          "MiB of the memory that revisions held for later requests may take"),
      mebibytes(
          "disk", 0, [](S& s) { return &s.daemon.disk; },
          "MiB that stored meshes may take; those used longest ago are made again when asked for; "
          "0: "
          "no limit"),
      whole(
          "max-nodes", {20, 5000000}, [](S& s) { return &s.daemon.max_nodes; },
          "most nodes that a request may ask for"),
  };
}

/// What it shares with other daemons.
std::vector<Option> tier_options() {
  return {
      text(
          "tier", "PLACE", [](S& s) { return &s.tier.place; },
          "shared tier: a folder that all daemons of a farm reach, or http://HOST:PORT/PATH for "
          "GET, PUT and HEAD; needs a store"),
      text(
          "tier-key-file", "FILE", [](S& s) { return &s.tier.key_file; },
          "the farm's key, 16 characters or more: what was not sealed with it is not used"),
      choice(
          "tier-ack", {"local", "tier"}, [](S& s) { return &s.tier.acknowledge; },
          "what has to have an edit before it is acknowledged"),
      text(
          "tier-s3-region", "REGION", [](S& s) { return &s.tier.s3_region; },
          "the tier is a bucket of S3: sign requests for it"),
      text(
          "tier-s3-credentials-file", "FILE", [](S& s) { return &s.tier.s3_credentials_file; },
          "line `ACCESS_KEY SECRET_KEY` of the bucket"),
      text(
          "catalogue", "ADDRESS", [](S& s) { return &s.designs.catalogue; },
          "PostgreSQL database that has names and heads of designs, for all daemons of a farm: "
          "postgresql://USER@HOST/DATABASE?passfile=FILE; needs a tier"),
      list(
          "replicas", "ADDRESS", [](S& s) { return &s.designs.replicas; },
          "without a catalogue: an address of the farm, by which clients reach a daemon of it; "
          "each design's names are at one of them; to be given for each"),
      text(
          "replica", "ADDRESS", [](S& s) { return &s.designs.replica; },
          "that of this daemon, one of `replicas`"),
  };
}

std::vector<Option> watch_options() {
  return {
      text(
          "dumps", "FOLDER", [](S& s) { return &s.daemon.dumps; },
          "folder in which every computation leaves its stages, for debugging"),
      choice(
          "log-level", {"trace", "debug", "info", "warning", "error", "off"},
          [](S& s) { return &s.log.level; }, "least important lines that are logged"),
      text(
          "log-file", "FILE", [](S& s) { return &s.log.file; },
          "file to append the log to, instead of stderr; opened anew on SIGHUP"),
      choice(
          "log-format", {"text", "json"}, [](S& s) { return &s.log.format; },
          "form of the log's lines"),
  };
}

std::vector<Option> make_table() {
  std::vector<Option> table;
  for (auto& options : {reach_options(), work_options(), tier_options(), watch_options()})
    table.insert(table.end(), options.begin(), options.end());
  return table;
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
