#pragma once

namespace CLI {
class App;
}

namespace remeshd::cli {

/// Adds examples to the end of the help of every command, in lines that begin with two blanks and
/// `remesh`.
void add_help_examples(CLI::App& app);

}  // namespace remeshd::cli
