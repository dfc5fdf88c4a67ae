#include "client/cli/mesh_outputs.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "client/cli/choice.h"
#include "client/cli/documents.h"
#include "client/cli/exit_code.h"
#include "client/cli/session.h"
#include "remeshd/mesh_file.h"

namespace remeshd::cli {
namespace {

bool is_model_file_name(const std::filesystem::path& file) {
  return file.extension() == ".step" || file.extension() == ".stp";
}

}  // namespace

const std::vector<std::string>& file_formats() {
  static const std::vector<std::string> formats{"vtu", "msh", "inp", kModelFormat};
  return formats;
}

void MeshOutputs::add_to(CLI::App& command) {
  command
      .add_option("-o,--output", files,
                  "Mesh file: .vtu, .msh or .inp; or the exact model: .step, .stp; `-`: to stdout; "
                  "may be given several times")
      ->required()
      ->type_name("OUT")
      ->expected(1)
      ->take_all();
  only(*command.add_option("--format", format, "Format, whatever the files are called"),
       file_formats());
}

void MeshOutputs::check(const std::string& text_file) const {
  for (const std::filesystem::path& file : files) {
    if (format.empty() && file == kStandardStream)
      throw UsageError("-o - needs --format vtu, msh, inp or step");
    if (format.empty() && !is_model_file_name(file) && !client::is_mesh_file_name(file))
      throw UsageError(
          file.string() +
          ": the ending must be .vtu, .msh, .inp, .step or .stp, unless --format tells it");
    check_text_file(file);
  }
  const auto streams =
      std::ranges::count(files, kStandardStream) + (text_file == kStandardStream ? 1 : 0);
  if (streams > 1) throw UsageError("only one of -o and --json can be `-`");
}

std::string MeshOutputs::format_of(const std::filesystem::path& file) const {
  if (!format.empty()) return format;
  return is_model_file_name(file) ? kModelFormat : file.extension().string().substr(1);
}

bool MeshOutputs::take_stdout() const {
  return std::ranges::find(files, kStandardStream) != files.end();
}

}  // namespace remeshd::cli
