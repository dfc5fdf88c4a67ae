#pragma once

#include <string>
#include <vector>

#include "client/cli/commands/command.h"
#include "client/cli/run.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace remeshd::cli {

/// What a command line says, once it is parsed.
struct Line {
  GlobalOptions options;
  bool verbose = false, quiet = false;
  Action action;
};

/// Builds all commands of `remesh`; `line` gets what is parsed and has to live as long as `app`.
void build(CLI::App& app, Line& line);

/// The commands below one, in the order of its help.
std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// What is wrong with a word that no command knows, with the word that may have been meant; empty
/// where the error is another. `app` has failed to parse.
std::string unknown_word(const CLI::App& app);

}  // namespace remeshd::cli
