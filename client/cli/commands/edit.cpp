#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/base.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/in_document.h"
#include "client/cli/mesh_base.h"
#include "client/cli/mesh_options.h"
#include "client/cli/reply.h"

namespace remeshd::cli {
namespace {

struct EditArguments {
  std::string base, edit;
  ReplyFiles files;
  MeshingOptions meshing;
  bool require_head = false;
};

int edit(Session& session, const EditArguments& arguments) {
  arguments.files.check();
  const Base base = resolve_base(arguments.base);
  remesh::v1::EditRevisionRequest request;
  *request.mutable_edit() = read_edit(arguments.edit);
  client::EditStream stream = session.stream();
  // A base that is meshed here takes the options, and the edit inherits them.
  const bool base_is_model = std::holds_alternative<remesh::v1::FeatureModel>(base);
  request.set_base(in_document(
      arguments.base, [&] { return mesh_base(session, stream, base, arguments.meshing); }));
  arguments.meshing.fill(request, !base_is_model);
  if (arguments.require_head) request.mutable_head()->set_require(true);
  const auto reply =
      in_document(arguments.edit, [&] { return stream.edit(std::move(request)).get(); });
  stream.finish();
  session.console().end_progress();
  deliver(session, reply, arguments.files);
  return kFine;
}

}  // namespace

void add_edit_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("edit", "Apply an edit to a revision and remesh it");
  const auto arguments = std::make_shared<EditArguments>();
  command
      ->add_option(
          "BASE", arguments->base,
          "Revision (design, design@N, id or 8 digits of it) or model file, whose name has "
          "a `/` or ends in .json; a model file is meshed first, with the options given, "
          "if the daemon lacks it")
      ->required();
  command->add_option("EDIT.json", arguments->edit, "Edit document")->required();
  arguments->files.add_to(*command);
  arguments->meshing.add_to(*command);
  command
      ->add_flag("--require-head", arguments->require_head,
                 "File nothing unless BASE is the head of its design; exit code 6 where it is not")
      ->excludes("--keep-head");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) { return edit(session, *arguments); };
  });
}

}  // namespace remeshd::cli
