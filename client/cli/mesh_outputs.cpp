#include "client/cli/mesh_outputs.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "client/cli/choice.h"
#include "client/cli/documents.h"
#include "client/cli/exit_code.h"
#include "client/cli/session.h"
#include "remeshd/mesh_file.h"

namespace remeshd::cli {

void MeshOutputs::add_to(CLI::App& command) {
  command
      .add_option("-o,--output", files,
                  "Mesh file: .vtu, .msh or .inp; `-`: to stdout; may be given several times")
      ->required()
      ->type_name("OUT")
      ->expected(1)
      ->take_all();
  only(*command.add_option("--format", format, "Format of the mesh, whatever the files are called"),
       {"vtu", "msh", "inp"});
}

void MeshOutputs::check(const std::string& text_file) const {
  for (const std::filesystem::path& file : files) {
    if (format.empty() && file == kStandardStream)
      throw UsageError("-o - needs --format vtu, msh or inp");
    if (format.empty() && !client::is_mesh_file_name(file))
      throw UsageError(file.string() +
                       ": the ending must be .vtu, .msh or .inp, unless --format tells it");
    check_text_file(file);
  }
  const auto streams =
      std::ranges::count(files, kStandardStream) + (text_file == kStandardStream ? 1 : 0);
  if (streams > 1) throw UsageError("only one of -o and --json can be `-`");
}

std::string MeshOutputs::format_of(const std::filesystem::path& file) const {
  return format.empty() ? file.extension().string().substr(1) : format;
}

bool MeshOutputs::take_stdout() const {
  return std::ranges::find(files, kStandardStream) != files.end();
}

}  // namespace remeshd::cli
