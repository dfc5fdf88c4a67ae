#include "client/cli/run.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "client/cli/command_line.h"
#include "client/cli/console.h"
#include "client/cli/exit_code.h"
#include "client/cli/in_document.h"
#include "remeshd/mesh_file.h"

namespace remeshd::cli {
namespace {

/// An address that stands for `--local`.
const std::string kLocal = "local";

/// The addresses of a list with commas between, without blanks.
std::vector<std::string> addresses_in(const std::string& list) {
  std::vector<std::string> addresses;
  std::istringstream in(list);
  for (std::string each; std::getline(in, each, ',');) {
    std::erase(each, ' ');
    addresses.push_back(each);
  }
  return addresses;
}

/// Sets `local` for the address that stands for it. Throws UsageError for options that contradict
/// each other.
void settle(GlobalOptions& options) {
  options.local = options.local || options.address == kLocal;
  if (!options.local && std::ranges::count(addresses_in(options.address), kLocal) > 0)
    throw UsageError("--address: `local` stands for this process, and cannot be one of several");
  if (!options.local && !options.store.empty())
    throw UsageError("--store is where --local keeps its revisions: without that it means nothing");
}

/// `a:1 or b:1`.
std::string or_list(const std::string& list) {
  std::string text;
  for (const std::string& each : addresses_in(list)) text += (text.empty() ? "" : " or ") + each;
  return text;
}

/// Says what went wrong and which exit code that is. `place`: where in a file; empty for an error
/// that is not in one.
int fail(Console& console, const remesh::v1::Error& error, const GlobalOptions& options,
         const std::string& place = {}) {
  remesh::v1::Error plain = error;
  plain.clear_hint();
  if (!place.empty()) {
    plain.clear_line();
    plain.clear_column();
  }
  if (exit_code(error) == kUnreachable && !options.local)
    console.error("no answer from a daemon at " + or_list(options.address) +
                  "; start one (remeshd), say where it is (--address), or do without (--local)");
  console.error((place.empty() ? "" : place + ": ") + client::describe(plain));
  for (const std::string& attempt : error.attempts()) console.error("tried: " + attempt);
  if (!error.hint().empty()) console.error("hint: " + error.hint());
  if (error.has_retry_after())
    console.error("try again in " + std::to_string(std::lround(std::ceil(error.retry_after()))) +
                  " s");
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
    if (e.get_exit_code() != 0) {
      if (const std::string unknown = unknown_word(app); !unknown.empty()) {
        console.error(unknown);
        return kUsage;
      }
    }
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
    return kFault;
  }
}

}  // namespace remeshd::cli
