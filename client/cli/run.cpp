#include "client/cli/run.h"

#include <CLI/CLI.hpp>
#include <cmath>

#include "client/cli/commands/command.h"
#include "client/cli/console.h"
#include "client/cli/exit_code.h"
#include "client/cli/in_document.h"
#include "remeshd/mesh_file.h"

#ifndef REMESHD_VERSION
#error "REMESHD_VERSION is the version of the project"
#endif

namespace remeshd::cli {
namespace {

constexpr const char* kFooter =
    "Data go to stdout, messages and progress to stderr.\n"
    "Exit codes: 0 fine, 2 usage, 3 invalid model, edit or name, 4 meshing failed,\n"
    "5 daemon not reachable, 6 busy or a head that moved, 7 denied, 8 file not readable or\n"
    "writable, 130 interrupted.";

struct Line {
  GlobalOptions options;
  bool verbose = false, quiet = false;
  Action action;
};

void build(CLI::App& app, Line& line) {
  app.fallthrough();  // commands hand global options up: they may stand behind the command
  app.require_subcommand(1);
  app.set_version_flag("--version", "remesh " REMESHD_VERSION);
  app.footer(kFooter);
  app.add_option("--address", line.options.address,
                 "Where the daemon listens [127.0.0.1:50051]; `local`: as --local")
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
  auto* verbose = app.add_flag("-v,--verbose", line.verbose, "Say more");
  app.add_flag("-q,--quiet", line.quiet, "Say nothing but errors")->excludes(verbose);

  add_mesh_command(app, line.action);
  add_edit_command(app, line.action);
  add_sweep_command(app, line.action);
  add_diff_command(app, line.action);
  add_validate_command(app, line.action);
  add_revision_commands(app, line.action);
  add_explain_command(app, line.action);
  add_report_command(app, line.action);
  add_head_command(app, line.action);
  add_recipe_commands(app, line.action);
  add_cache_command(app, line.action);
  add_quality_command(app, line.action);
  add_types_command(app, line.action);
  add_info_command(app, line.action);
}

/// What options mean together.
void settle(GlobalOptions& options) {
  options.local = options.local || options.address == "local";
  if (!options.local && !options.store.empty())
    throw UsageError("--store is where --local keeps its revisions: without that it means nothing");
}

/// Says what went wrong and which exit code that is. `place`: in a file, else empty.
int fail(Console& console, const remesh::v1::Error& error, const GlobalOptions& options,
         const std::string& place = {}) {
  remesh::v1::Error plain = error;
  plain.clear_hint();
  if (!place.empty()) {
    plain.clear_line();
    plain.clear_column();
  }
  if (exit_code(error) == kUnreachable && !options.local)
    console.error("no answer from a daemon at " + options.address +
                  "; start one (remeshd), say where it is (--address), or do without (--local)");
  console.error((place.empty() ? "" : place + ": ") + client::describe(plain));
  for (const std::string& attempt : error.attempts()) console.error("tried: " + attempt);
  if (!error.hint().empty()) console.error("hint: " + error.hint());
  if (error.has_retry_after())
    console.error("try again in " + std::to_string(std::lround(error.retry_after() + 0.5)) + " s");
  console.detail("code " + client::code_name(error.code()) + ", reason " +
                 client::reason_name(error) + ", stage " + error.stage());
  return exit_code(error);
}

int act(const Line& line, const Surroundings& surroundings, Console& console) {
  Session session(surroundings, line.options, console);
  try {
    const int code = line.action(session);
    session.poll();
    session.check_output();
    return code;
  } catch (...) {
    // A call that an interrupt broke off fails as it may; the interrupt is what counts.
    if (surroundings.stop.stop_requested()) throw Interrupted();
    throw;
  }
}

}  // namespace

int run(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  Console console(surroundings.err, surroundings.terminal);
  CLI::App app("Mesh feature models and remesh them after edits", "remesh");
  Line line;
  try {
    build(app, line);
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    console.set_verbosity(line.quiet     ? Verbosity::Quiet
                          : line.verbose ? Verbosity::Verbose
                                         : Verbosity::Normal);
    settle(line.options);
    return act(line, surroundings, console);
  } catch (const CLI::ParseError& e) {
    const int code = app.exit(e, surroundings.out, surroundings.err);
    if (code != 0) return kUsage;
    return surroundings.out.flush() ? kFine : kFileFailed;
  } catch (const UsageError& e) {
    console.error(e.what());
    return kUsage;
  } catch (const Interrupted&) {
    console.error("interrupted");
    return kInterrupted;
  } catch (const InDocument& e) {
    return fail(console, e.detail(), line.options, e.place());
  } catch (const client::CallError& e) {
    return fail(console, e.detail(), line.options);
  } catch (const DocumentError& e) {
    return fail(console, to_detail(e.info()), line.options);
  } catch (const Error& e) {
    return fail(console, to_detail(e.info()), line.options);
  } catch (const client::FileError& e) {
    console.error(e.what());
    return kFileFailed;
  } catch (const std::exception& e) {
    console.error(e.what());
    return kFailed;
  }
}

}  // namespace remeshd::cli
