#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/base.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/table.h"
#include "proto/document_error.h"
#include "proto/json_writer.h"

namespace remeshd::cli {
namespace {

struct ValidateArguments {
  std::string file, base, json;
};

remesh::v1::ValidateReply ask(Session& session, const ValidateArguments& arguments, Named named) {
  if (auto* model = std::get_if<remesh::v1::FeatureModel>(&named)) {
    if (!arguments.base.empty()) throw UsageError("--base goes with an edit, not with a model");
    remesh::v1::ValidateModelRequest request;
    *request.mutable_model() = std::move(*model);
    return session.client().validate(request, session.call());
  }
  remesh::v1::ValidateEditRequest request;
  *request.mutable_edit() = std::move(std::get<remesh::v1::ModelEdit>(named));
  Base base = resolve_base(arguments.base);
  if (auto* revision = std::get_if<std::string>(&base))
    request.set_base(*revision);
  else
    *request.mutable_model() = std::move(std::get<remesh::v1::FeatureModel>(base));
  return session.client().validate(request, session.call());
}

int validate(Session& session, const ValidateArguments& arguments) {
  Named named = resolve(arguments.file);
  if (std::holds_alternative<std::string>(named))
    throw error::document_unreadable(arguments.file, "no such file");
  if (std::holds_alternative<remesh::v1::ModelEdit>(named) && arguments.base.empty()) {
    session.console().note(arguments.file +
                           " is a well-formed edit; --base BASE checks it with its model");
    return kFine;
  }
  const auto reply = ask(session, arguments, std::move(named));
  if (!arguments.json.empty()) session.write_text(arguments.json, write_json(reply));
  if (arguments.json == "-") return kFine;
  write_table(session.out(), {{"model", reply.model().name()},
                              {"features", std::to_string(reply.model().features_size())},
                              {"volume", exact(reply.volume())},
                              {"area", exact(reply.area())},
                              {"cells", std::to_string(reply.cells())},
                              {"faces", std::to_string(reply.faces())},
                              {"edges", std::to_string(reply.edges())},
                              {"vertices", std::to_string(reply.vertices())}});
  return kFine;
}

}  // namespace

void add_validate_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("validate", "Check a model or an edit without meshing");
  const auto arguments = std::make_shared<ValidateArguments>();
  command->add_option("FILE", arguments->file, "Model or edit document")->required();
  command
      ->add_option(
          "--base", arguments->base,
          "What an edit is for: revision or model file; without it only its form is checked")
      ->type_name("BASE");
  command->add_option("--json", arguments->json, "Write the findings here; `-`: to stdout")
      ->type_name("FILE");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) { return validate(session, *arguments); };
  });
}

}  // namespace remeshd::cli
