#include "client/cli/completion.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "client/cli/choice.h"
#include "client/cli/command_line.h"

namespace remeshd::cli {
namespace {

struct CompletedOption {
  std::vector<std::string> longs, shorts;  ///< without dashes
  std::string help;
  bool takes_value = false;
  std::vector<std::string> values;  ///< where it takes words of a list
};

/// A command as its completion sees it.
struct CompletedCommand {
  std::string path;  ///< `cache ls`; empty: `remesh` itself
  std::string help;
  std::vector<CompletedOption> options;
  std::vector<std::string> words;  ///< that its arguments may be
  std::vector<CompletedCommand> commands;
};

/// The beginning of a help text, up to its first semicolon or line end.
std::string brief(const std::string& help) { return help.substr(0, help.find_first_of(";\n")); }

CompletedCommand describe(const CLI::App& app, const std::string& path) {
  CompletedCommand command{.path = path, .help = brief(app.get_description())};
  for (const CLI::Option* option : app.get_options()) {
    const auto values = words_of(option->get_type_name());
    if (option->get_positional()) {
      command.words.insert(command.words.end(), values.begin(), values.end());
      continue;
    }
    command.options.push_back({.longs = option->get_lnames(),
                               .shorts = option->get_snames(),
                               .help = brief(option->get_description()),
                               .takes_value = option->get_items_expected_max() > 0,
                               .values = values});
  }
  for (const CLI::App* each : commands_of(app))
    command.commands.push_back(
        describe(*each, path.empty() ? each->get_name() : path + " " + each->get_name()));
  return command;
}

std::vector<const CompletedCommand*> flattened(const CompletedCommand& command) {
  std::vector<const CompletedCommand*> all{&command};
  for (const CompletedCommand& each : command.commands)
    for (const CompletedCommand* below : flattened(each)) all.push_back(below);
  return all;
}

std::vector<std::string> flags_of(const CompletedOption& option) {
  std::vector<std::string> flags;
  for (const std::string& name : option.longs) flags.push_back("--" + name);
  for (const std::string& name : option.shorts) flags.push_back("-" + name);
  return flags;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// The last word of a path.
std::string name_of(const CompletedCommand& command) {
  return command.path.substr(command.path.rfind(' ') + 1);
}

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// Options of a command and those of `remesh` that may stand behind it.
std::vector<CompletedOption> options_within(const CompletedCommand& top,
                                            const CompletedCommand& command) {
  std::vector<CompletedOption> options = command.options;
  if (&top != &command)
    for (const CompletedOption& option : top.options)
      if (option.longs != std::vector<std::string>{"help"}) options.push_back(option);
  return options;
}

/// `case` lines that follow the words so far to the command that they name; bash and zsh.
std::string path_cases(const std::vector<const CompletedCommand*>& all) {
  std::string text;
  for (const CompletedCommand* command : all) {
    if (command->path.empty()) continue;
    const std::string path = quoted(" " + command->path);
    text.append("      ").append(path).append(") at=").append(path).append(" ;;\n");
  }
  return text;
}

/// `case` lines for the word behind an option that takes a value; bash and zsh.
std::string value_cases(const CompletedCommand& top,
                        const std::vector<const CompletedCommand*>& all, const std::string& offer,
                        const std::string& files) {
  std::string text;
  for (const CompletedCommand* command : all) {
    for (const CompletedOption& option : options_within(top, *command)) {
      if (!option.takes_value) continue;
      const std::string at = command->path.empty() ? "" : " " + command->path;
      std::vector<std::string> patterns;
      for (const std::string& flag : flags_of(option)) patterns.push_back(quoted(at + " " + flag));
      text += "    " + joined(patterns, "|") + ") " +
              (option.values.empty() ? files : offer + " " + joined(option.values, " ")) +
              "; return ;;\n";
    }
  }
  return text;
}

/// `case` lines that set `flags` and `words` of each command; bash and zsh.
std::string word_cases(const CompletedCommand& top,
                       const std::vector<const CompletedCommand*>& all) {
  std::string text;
  for (const CompletedCommand* command : all) {
    std::vector<std::string> flags, words = command->words;
    for (const CompletedOption& option : options_within(top, *command))
      for (const std::string& flag : flags_of(option)) flags.push_back(flag);
    for (const CompletedCommand& each : command->commands) words.push_back(name_of(each));
    text += "    " + quoted(command->path.empty() ? "" : " " + command->path) +
            ") flags=" + quoted(joined(flags, " ")) + "; words=" + quoted(joined(words, " ")) +
            " ;;\n";
  }
  return text;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

constexpr const char* kBash = R"(# bash completion of remesh; made by `remesh completion bash`
_remesh_offer() { COMPREPLY=($(compgen -W "$*" -- "${COMP_WORDS[COMP_CWORD]}")); }
_remesh() {
  local word=${COMP_WORDS[COMP_CWORD]} at= flags= words= k
  COMPREPLY=()
  for ((k = 1; k < COMP_CWORD; ++k)); do
    case "$at ${COMP_WORDS[k]}" in
@PATHS@    esac
  done
  case "$at ${COMP_WORDS[COMP_CWORD - 1]}" in
@VALUES@  esac
  case $at in
@WORDS@  esac
  if [[ $word == -* ]]; then _remesh_offer "$flags"; else _remesh_offer "$words"; fi
}
complete -o default -F _remesh remesh
)";

constexpr const char* kZsh = R"(#compdef remesh
# zsh completion of remesh; made by `remesh completion zsh`
_remesh() {
  local at= flags= candidates= k
  for ((k = 2; k < CURRENT; ++k)); do
    case "$at ${words[k]}" in
@PATHS@    esac
  done
  case "$at ${words[CURRENT - 1]}" in
@VALUES@  esac
  case $at in
@WORDS@  esac
  if [[ ${words[CURRENT]} == -* ]]; then
    compadd -- ${=flags}
  elif [[ -n $candidates ]]; then
    compadd -- ${=candidates}
  else
    _files
  fi
}
if [[ ${funcstack[1]} == _remesh ]]; then _remesh; else compdef _remesh remesh; fi
)";

/// fish's condition for the options and words of a command.
std::string fish_condition(const CompletedCommand& command) {
  const std::size_t blank = command.path.find(' ');
  std::string text = "__fish_seen_subcommand_from " + command.path.substr(0, blank);
  if (blank != std::string::npos)
    text += "; and __fish_seen_subcommand_from " + command.path.substr(blank + 1);
  return text;
}

std::string fish_option(const CompletedCommand& command, const CompletedOption& option) {
  std::string line = "complete -c remesh";
  if (!command.path.empty()) line += " -n " + quoted(fish_condition(command));
  for (const std::string& name : option.longs) line += " -l " + name;
  for (const std::string& name : option.shorts) line += " -s " + name;
  if (!option.values.empty())
    line += " -x -a " + quoted(joined(option.values, " "));
  else if (option.takes_value)
    line += " -r -F";
  return line + " -d " + quoted(option.help) + "\n";
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  const CompletedCommand top = describe(app, "");
  const auto all = flattened(top);
  std::string text = kBash;
  replace_all(text, "@PATHS@", path_cases(all));
  replace_all(text, "@VALUES@", value_cases(top, all, "_remesh_offer", ":"));
  replace_all(text, "@WORDS@", word_cases(top, all));
  return text;
}

std::string zsh_completion(const CLI::App& app) {
  const CompletedCommand top = describe(app, "");
  const auto all = flattened(top);
  std::string words = word_cases(top, all);
  replace_all(words, "; words=", "; candidates=");  // in zsh `words` is the command line
  std::string text = kZsh;
  replace_all(text, "@PATHS@", path_cases(all));
  replace_all(text, "@VALUES@", value_cases(top, all, "compadd --", "_files"));
  replace_all(text, "@WORDS@", words);
  return text;
}

std::string fish_completion(const CLI::App& app) {
  const CompletedCommand top = describe(app, "");
  std::string text = "# fish completion of remesh; made by `remesh completion fish`\n";
  for (const CompletedCommand* command : flattened(top)) {
    std::vector<std::string> names;
    for (const CompletedCommand& each : command->commands) names.push_back(name_of(each));
    const std::string none = command->path.empty() ? "__fish_use_subcommand"
                                                   : fish_condition(*command) +
                                                         "; and not __fish_seen_subcommand_from " +
                                                         joined(names, " ");
    for (const CompletedCommand& each : command->commands)
      text += "complete -c remesh -f -n " + quoted(none) + " -a " + name_of(each) + " -d " +
              quoted(each.help) + "\n";
    if (!command->words.empty())
      text += "complete -c remesh -f -n " + quoted(fish_condition(*command)) + " -a " +
              quoted(joined(command->words, " ")) + "\n";
    for (const CompletedOption& option : command->options) text += fish_option(*command, option);
  }
  return text;
}

}  // namespace remeshd::cli
