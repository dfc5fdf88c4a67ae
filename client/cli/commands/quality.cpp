#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/measure.h"
#include "client/formats/read_mesh.h"
#include "remeshd/mesh_file.h"

namespace remeshd::cli {

void add_quality_command(CLI::App& app, Action& action) {
  struct Arguments {
    std::string mesh;
    std::optional<double> exact_volume;
  };
  auto* command = app.add_subcommand("quality", "Measure a mesh file; one JSON object");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("MESH", arguments->mesh, "Mesh file: .vtu, .msh (4.1) or .inp")->required();
  command
      ->add_option("--exact-volume", arguments->exact_volume,
                   "Volume to compare with: adds vol_err, the relative error")
      ->check(CLI::PositiveNumber)
      ->type_name("V");
  command->footer(
      "vl: volume-length 6 sqrt(2) V / l_rms^3; dih: dihedral angles in degrees; badfaces: facets "
      "of "
      "more than two tets; neg: flat or inverted tets; f10, f20: share of angles below 10 and 20 "
      "degrees; f_tet_10, f_tet_20: share of tets that have one.");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      try {
        const client::FileMesh mesh = client::read_mesh(arguments->mesh);
        session.out() << to_json(measure(mesh, arguments->exact_volume)) << std::flush;
      } catch (const client::FormatError& e) {
        session.console().error(e.what());
        return kInvalid;
      }
      return kFine;
    };
  });
}

}  // namespace remeshd::cli
