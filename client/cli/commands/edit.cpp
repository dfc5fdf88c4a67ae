#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "client/cli/base.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/in_document.h"
#include "client/cli/mesh_base.h"
#include "client/cli/mesh_options.h"
#include "client/cli/reply.h"
#include "client/cli/short_edits.h"

namespace remeshd::cli {
namespace {

struct EditArguments {
  std::string base, document;
  std::vector<std::string> assignments, removed;  ///< applied after those of the document
  ReplyFiles files;
  MeshingOptions meshing;
  bool require_head = false;
};

remesh::v1::ModelEdit edit_of(Documents& documents, const EditArguments& arguments) {
  remesh::v1::ModelEdit edit;
  if (!arguments.document.empty()) edit = read_edit(documents, arguments.document);
  for (const std::string& assignment : arguments.assignments) add_assignment(edit, assignment);
  for (const std::string& feature : arguments.removed)
    edit.add_edits()->mutable_remove_feature()->set_feature(feature);
  if (arguments.document.empty() && edit.edits().empty())
    throw UsageError("nothing to change: wanted is EDIT.json, --set or --remove");
  return edit;
}

/// The reply to a request, with the place of an error in the edit's document.
remesh::v1::RevisionResult reply_to(Documents& documents, client::EditStream& stream,
                                    remesh::v1::EditRevisionRequest request,
                                    const EditArguments& arguments) {
  const auto send = [&] { return stream.edit(std::move(request)).get(); };
  return arguments.document.empty() ? send() : in_document(documents, arguments.document, send);
}

int edit(Session& session, const EditArguments& arguments) {
  arguments.files.check();
  check_one_stdin(arguments.base, arguments.document);
  const Base base = resolve_base(session.documents(), arguments.base);
  remesh::v1::EditRevisionRequest request;
  *request.mutable_edit() = edit_of(session.documents(), arguments);
  client::EditStream stream = session.stream();
  // A base that is meshed here takes the options, and the edit inherits them.
  const bool base_is_model = std::holds_alternative<remesh::v1::FeatureModel>(base);
  const MeshedBase from = in_document(session.documents(), arguments.base, [&] {
    return mesh_base(session, stream, base, arguments.meshing);
  });
  request.set_base(from.revision);
  arguments.meshing.fill(request, !base_is_model);
  if (request.design().empty()) request.set_design(from.design);
  if (arguments.require_head) request.mutable_head()->set_require(true);
  const auto reply = reply_to(session.documents(), stream, std::move(request), arguments);
  stream.finish();
  session.console().end_progress();
  deliver(session, reply, arguments.files);
  return kFine;
}

}  // namespace

void add_edit_command(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("edit",
                         "Apply an edit to a revision and remesh it; options of the mesh that "
                         "are left out are the base's");
  const auto arguments = std::make_shared<EditArguments>();
  command
      ->add_option(
          "BASE", arguments->base,
          "Revision (design, design@N, id or 8 digits of it) or model file, whose name has "
          "a `/` or ends in .json (`-`: stdin); a model file is meshed first, with the options "
          "given, "
          "if the daemon lacks it")
      ->required();
  command->add_option("EDIT.json", arguments->document, "Edit document; `-`: stdin");
  command
      ->add_option("--set", arguments->assignments,
                   "Set a parameter of the model, or one of a feature (hole.radius=9), to a number "
                   "or an expression; may be given several times, after EDIT.json in effect")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
  command->add_option("--remove", arguments->removed, "Remove a feature; likewise, after --set")
      ->type_name("FEATURE")
      ->expected(1)
      ->take_all();
  arguments->files.add_to(*command);
  arguments->meshing.add_to(*command, MeshingOptions::Unset::OfBase);
  command
      ->add_flag("--require-head", arguments->require_head,
                 "File nothing unless BASE is the head of its design; exit code 6 where it is not")
      ->excludes("--keep-head");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) { return edit(session, *arguments); };
  });
}

}  // namespace remeshd::cli
