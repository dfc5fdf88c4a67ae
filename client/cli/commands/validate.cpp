#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/base.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/in_document.h"
#include "client/cli/table.h"
#include "client/cli/warnings.h"
#include "proto/json_writer.h"

namespace remeshd::cli {
namespace {

struct ValidateArguments {
  std::string file, base, json;
};

using Document = std::variant<remesh::v1::FeatureModel, remesh::v1::ModelEdit>;

remesh::v1::ModelCheck ask(Session& session, const ValidateArguments& arguments,
                           Document document) {
  if (auto* model = std::get_if<remesh::v1::FeatureModel>(&document)) {
    if (!arguments.base.empty()) throw UsageError("--base goes with an edit, not with a model");
    remesh::v1::ValidateModelRequest request;
    *request.mutable_model() = std::move(*model);
    return session.client().validate(request, session.call());
  }
  remesh::v1::ValidateEditRequest request;
  *request.mutable_edit() = std::move(std::get<remesh::v1::ModelEdit>(document));
  Base base = resolve_base(arguments.base);
  if (auto* revision = std::get_if<std::string>(&base))
    request.set_base(*revision);
  else
    *request.mutable_base_model() = std::move(std::get<remesh::v1::FeatureModel>(base));
  return session.client().validate(request, session.call());
}

int validate(Session& session, const ValidateArguments& arguments) {
  Document document = read_either(arguments.file);
  if (std::holds_alternative<remesh::v1::ModelEdit>(document) && arguments.base.empty()) {
    session.console().note(arguments.file +
                           " is a well-formed edit; --base BASE checks it with its model");
    return kFine;
  }
  const auto check =
      in_document(arguments.file, [&] { return ask(session, arguments, std::move(document)); });
  show_warnings(session, check.warnings());
  if (!arguments.json.empty()) session.write_text(arguments.json, write_json(check));
  if (arguments.json == "-") return kFine;
  write_table(session.out(), {{"model", check.model().name()},
                              {"features", std::to_string(check.model().features_size())},
                              {"volume", exact(check.volume())},
                              {"area", exact(check.area())},
                              {"cells", std::to_string(check.cells())},
                              {"faces", std::to_string(check.faces())},
                              {"edges", std::to_string(check.edges())},
                              {"vertices", std::to_string(check.vertices())}});
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
