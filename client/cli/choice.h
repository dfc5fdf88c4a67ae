#pragma once

#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace remeshd::cli {

/// Lets an option take these words alone. They stand for its value in the help (`vtu|msh|inp`),
/// which completion reads; another word is told with the one that may have been meant.
void only(CLI::Option& option, const std::vector<std::string>& words);

/// The words that the name of an option's value lists: of `vtu|msh|inp` all three, of `K|auto` the
/// one in small letters; none of `FILE`.
std::vector<std::string> words_of(const std::string& type_name);

}  // namespace remeshd::cli
