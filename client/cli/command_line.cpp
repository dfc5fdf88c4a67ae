#include "client/cli/command_line.h"

#include <CLI/CLI.hpp>

#include "client/cli/help_examples.h"
#include "engine/base/text/nearest_name.h"

#ifndef REMESHD_VERSION
#error "REMESHD_VERSION is the version of the project"
#endif

namespace remeshd::cli {
namespace {

constexpr const char* kFooter =
    "Data go to stdout, messages and progress to stderr.\n"
    "Exit codes: 0 fine, 1 a fault of remesh itself, 2 usage, 3 invalid model, edit or name,\n"
    "4 meshing failed, 5 daemon not reachable, 6 busy or a head that moved, 7 denied, 8 file or\n"
    "stream not readable or writable, 130 interrupted.";

void add_global_options(CLI::App& app, Line& line) {
  app.add_option(
         "--address", line.options.address,
         "Where the daemon listens [127.0.0.1:50051]; of daemons that share a tier all, with "
         "commas between: where one is not available the next takes over; `local`: as --local")
      ->envname("REMESH_ADDRESS")
      ->type_name("HOST:PORT");
  const auto file = [&app](const char* flag, const char* variable, std::filesystem::path& path,
                           const char* help) {
    app.add_option(flag, path, help)->envname(variable)->type_name("FILE");
  };
  file("--tls-ca", "REMESH_TLS_CA", line.options.tls_ca,
       "Use TLS: certificates (PEM) of who signs the daemon's");
  file("--tls-cert", "REMESH_TLS_CERT", line.options.tls_cert, "Own certificate (PEM) to show");
  file("--tls-key", "REMESH_TLS_KEY", line.options.tls_key, "Its key (PEM)");
  file("--token-file", "REMESH_TOKEN_FILE", line.options.token_file,
       "File with the token that the daemon knows its user by");
  app.add_flag("--local", line.options.local, "Work without a daemon, in this process");
  app.add_option("--store", line.options.store,
                 "Where --local keeps its revisions [$XDG_CACHE_HOME/remeshd, ~/.cache/remeshd]")
      ->type_name("DIR");
  app.add_option("--timeout", line.options.timeout, "Give a call up after so many seconds")
      ->check(CLI::Range(0.001, 1e6))
      ->type_name("S");
  app.add_option("--patience", line.options.patience,
                 "Try again for so many seconds where no daemon is available any more [30]")
      ->check(CLI::Range(0.0, 1e6))
      ->type_name("S");
  auto* verbose = app.add_flag("-v,--verbose", line.verbose, "Say more, and progress in pipes too");
  app.add_flag("-q,--quiet", line.quiet, "Neither warnings nor progress")->excludes(verbose);
}

/// The innermost command that was given.
const CLI::App& chosen(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : chosen(*parsed.front());
}

void add_flags(const CLI::App& app, std::vector<std::string>& names) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
}

}  // namespace

void build(CLI::App& app, Line& line) {
  app.fallthrough();  // commands hand global options up: they may stand behind the command
  app.require_subcommand(1);
  app.set_version_flag("--version", "remesh " REMESHD_VERSION);
  app.footer(kFooter);
  add_global_options(app, line);
  add_mesh_command(app, line.action);
  add_edit_command(app, line.action);
  add_sweep_command(app, line.action);
  add_diff_command(app, line.action);
  add_validate_command(app, line.action);
  add_example_command(app, line.action);
  add_schema_command(app, line.action);
  add_revision_commands(app, line.action);
  add_blame_command(app, line.action);
  add_explain_command(app, line.action);
  add_report_command(app, line.action);
  add_head_command(app, line.action);
  add_recipe_commands(app, line.action);
  add_cache_command(app, line.action);
  add_quality_command(app, line.action);
  add_types_command(app, line.action);
  add_info_command(app, line.action);
  add_completion_command(app, line.action);
  add_help_examples(app);
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string unknown_word(const CLI::App& app) {
  const CLI::App& command = chosen(app);
  const auto commands = commands_of(command);
  for (const std::string& given : app.remaining(true)) {
    const bool flag = given.size() > 1 && given.front() == '-';
    std::vector<std::string> names;
    if (flag) {
      add_flags(command, names);
      if (&command != &app) add_flags(app, names);
    } else if (!commands.empty()) {
      for (const CLI::App* each : commands) names.push_back(each->get_name());
    } else {
      continue;
    }
    const std::string word = given.substr(0, flag ? given.find('=') : std::string::npos);
    return (flag ? "unknown option " : "unknown command ") + word + suggestion(word, names);
  }
  return {};
}

}  // namespace remeshd::cli
