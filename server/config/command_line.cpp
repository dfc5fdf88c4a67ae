#include "server/config/command_line.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <deque>
#include <utility>

#include "engine/base/text/nearest_name.h"
#include "server/config/config_error.h"

#ifndef REMESHD_VERSION
#error "the build gives the version"
#endif

namespace remeshd {
namespace {

/// A flag that may be given, and what was given.
struct Flag {
  const Option* option;
  CLI::Option* parsed;
};

std::string default_text(const Option& option) {
  static const Settings defaults;
  const OptionValue value = option.get(defaults);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* texts = std::get_if<std::vector<std::string>>(&value))
    return texts->empty() ? "" : texts->front();
  if (option.kind == OptionKind::Switch) return "";
  return to_toml(value);
}

Flag add_flag(CLI::App& app, const Option& option) {
  if (option.kind == OptionKind::Switch) {
    // `--reflection` and `--reflection=false`; the value is read below, as every other.
    return {&option, app.add_flag(option.flag(), option.help)};
  }
  CLI::Option* const parsed = app.add_option(option.flag(), option.help);
  parsed->type_name(option.argument)->default_str(default_text(option));
  parsed->type_size(1)->expected(1);
  if (option.kind == OptionKind::List)
    parsed->expected(1, 1000);
  else
    parsed->multi_option_policy(CLI::MultiOptionPolicy::Throw);
  return {&option, parsed};
}

OptionValue value_of(const Flag& flag) {
  const std::vector<std::string>& texts = flag.parsed->results();
  if (flag.option->kind == OptionKind::List) return texts;
  if (texts.size() > 1) throw ConfigError(flag.option->flag() + " is given twice");
  try {
    return parse_option_value(flag.option->kind, texts.empty() ? "" : texts.front());
  } catch (const ConfigError& why) {
    throw ConfigError(flag.option->flag() + ": " + why.what());
  }
}

std::vector<std::string> flag_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

}  // namespace

CommandLine read_command_line(std::vector<std::string> arguments) {
  CommandLine out;
  CLI::App app("Serves remesh.v1: tetrahedral meshes of feature models and of their edits.",
               "remeshd");
  app.footer(
      "Every option can be given in three ways, in rising precedence: in the file as "
      "`maxNodes = 20000`, in the environment as REMESHD_MAX_NODES=20000, as a flag.");
  app.allow_extras();
  app.set_version_flag("--version", std::string("remeshd " REMESHD_VERSION));
  app.add_option("--config", out.config_file, "TOML file with options; or REMESHD_CONFIG")
      ->type_name("FILE");
  bool check = false, print = false;
  app.add_flag("--check-config", check, "tell what is wrong with the configuration, and end");
  app.add_flag("--print-config", print, "print the configuration as a file for --config, and end");
  CLI::Option* const health = app.add_option(
      "--health", out.health_address,
      "ask the daemon at this address, or at its own, how it is, and end: exit code 0 serving, 1 "
      "not serving, 2 unreachable");
  health->type_name("[ADDRESS]")->expected(0, 1);
  bool live = false;
  app.add_flag("--live", live,
               "with --health: whether its process answers, not whether it is ready");
  std::vector<Flag> flags;
  for (const Option& option : option_table()) flags.push_back(add_flag(app, option));

  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes a vector from its end
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    out.answer = app.help();
    return out;
  } catch (const CLI::CallForVersion& version) {
    out.answer = std::string(version.what()) + '\n';
    return out;
  } catch (const CLI::ParseError& why) {
    throw ConfigError(why.what());
  }
  if (const auto extras = app.remaining(); !extras.empty()) {
    const std::string name = extras.front().substr(0, extras.front().find('='));
    throw ConfigError(name + (name.starts_with('-') ? " is unknown" : " belongs to no flag") +
                      suggestion(name, flag_names(app)));
  }
  for (const Flag& flag : flags)
    if (flag.parsed->count() > 0)
      out.given.push_back({flag.option, value_of(flag), flag.option->flag()});
  out.health_service = live ? "liveness" : "remesh.v1.RemeshService";
  if (health->count() > 0) out.task = Task::Health;
  if (check) out.task = Task::CheckConfig;
  if (print) out.task = Task::PrintConfig;
  return out;
}

}  // namespace remeshd
