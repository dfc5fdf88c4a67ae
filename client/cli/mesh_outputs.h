#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace remeshd::cli {

/// What `--format` takes; `step` is the model's exact boundary, all others are the mesh.
inline constexpr const char* kModelFormat = "step";
const std::vector<std::string>& file_formats();

/// Where a mesh goes, or its model, and in which formats.
struct MeshOutputs {
  std::vector<std::filesystem::path> files;  ///< of one revision; `-`: to stdout
  std::string format{};  ///< of all, one of `file_formats`; empty: by the names' endings

  /// The options -o and --format.
  void add_to(CLI::App& command);
  /// Throws UsageError unless each file has a format and at most one thing goes to stdout,
  /// FileError unless the folder of each is there. `text_file`: name of the text file that is
  /// written beside the meshes; may be empty. To be called before a mesh is made.
  void check(const std::string& text_file) const;
  /// Pre: `check` has not thrown.
  [[nodiscard]] std::string format_of(const std::filesystem::path& file) const;
  /// Whether stdout is taken, so that what people read goes to the messages.
  [[nodiscard]] bool take_stdout() const;
};

}  // namespace remeshd::cli
