#pragma once

#include <string>

namespace CLI {
class App;
}

namespace remeshd::cli {

/// Scripts that complete the words of `remesh` in a shell, made from its commands and options, so
/// that they have all of them. Where a word is neither, nor of a list, files are offered.
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

}  // namespace remeshd::cli
