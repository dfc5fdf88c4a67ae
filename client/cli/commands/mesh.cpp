#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/base.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/mesh_options.h"
#include "client/cli/reply.h"

namespace remeshd::cli {
namespace {

struct MeshArguments {
  std::string model, mesh_file, report_file;
  MeshingOptions meshing;
};

int mesh(Session& session, const MeshArguments& arguments) {
  check_mesh_file(arguments.mesh_file);
  check_text_file(arguments.report_file);
  remesh::v1::CreateRevisionRequest request;
  *request.mutable_model() = read_model(arguments.model);
  arguments.meshing.fill(request, true);
  client::EditStream stream = session.stream();
  const auto reply = stream.create(std::move(request)).get();
  stream.finish();
  session.console().end_progress();
  deliver(session, reply, arguments.mesh_file, arguments.report_file);
  return kFine;
}

}  // namespace

void add_mesh_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("mesh", "Mesh a model");
  const auto arguments = std::make_shared<MeshArguments>();
  command->add_option("MODEL.json", arguments->model, "Model document")->required();
  command->add_option("-o,--output", arguments->mesh_file, "Mesh file: .vtu, .msh or .inp")
      ->required()
      ->type_name("OUT");
  command->add_option("--json", arguments->report_file, "Write the Report here; `-`: to stdout")
      ->type_name("FILE");
  arguments->meshing.add_to(*command);
  command->callback([arguments, &action] {
    action = [arguments](Session& session) { return mesh(session, *arguments); };
  });
}

}  // namespace remeshd::cli
