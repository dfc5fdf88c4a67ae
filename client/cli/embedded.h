#pragma once

#include <string_view>
#include <vector>

namespace remeshd::cli {

/// A file of the source tree that is part of the program.
struct EmbeddedText {
  std::string_view name;  ///< the file's, without `.json` or `.schema.json`
  std::string_view text;
};

/// `model` and `edit`, of client/schema; the second refers to definitions of the first.
const std::vector<EmbeddedText>& schema_files();
/// Those of client/examples/models, by name.
const std::vector<EmbeddedText>& example_files();

}  // namespace remeshd::cli
