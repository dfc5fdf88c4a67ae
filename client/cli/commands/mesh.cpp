#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/base.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/in_document.h"
#include "client/cli/mesh_options.h"
#include "client/cli/reply.h"

namespace remeshd::cli {
namespace {

struct MeshArguments {
  std::string model;
  ReplyFiles files;
  MeshingOptions meshing;
  bool head = false;
};

int mesh(Session& session, const MeshArguments& arguments) {
  arguments.files.check();
  remesh::v1::CreateRevisionRequest request;
  *request.mutable_model() = read_model(session.documents(), arguments.model);
  arguments.meshing.fill(request, true);
  if (arguments.head) request.mutable_head()->set_advance(true);
  client::EditStream stream = session.stream();
  const auto reply = in_document(session.documents(), arguments.model,
                                 [&] { return stream.create(std::move(request)).get(); });
  stream.finish();
  session.console().end_progress();
  deliver(session, reply, arguments.files);
  return kFine;
}

}  // namespace

void add_mesh_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("mesh", "Mesh a model");
  const auto arguments = std::make_shared<MeshArguments>();
  command->add_option("MODEL.json", arguments->model, "Model document; `-`: stdin")->required();
  arguments->files.add_to(*command);
  arguments->meshing.add_to(*command);
  command
      ->add_flag("--head", arguments->head,
                 "Make the revision the head of its design, also where the design began with "
                 "another model")
      ->excludes("--keep-head");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) { return mesh(session, *arguments); };
  });
}

}  // namespace remeshd::cli
