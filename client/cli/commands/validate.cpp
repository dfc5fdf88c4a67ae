#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "client/cli/base.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/in_document.h"
#include "client/cli/mesh_options.h"
#include "client/cli/table.h"
#include "client/cli/warnings.h"
#include "proto/json_writer.h"

namespace remeshd::cli {
namespace {

struct ValidateArguments {
  std::string file, base, json;
  MeshingOptions meshing;
};

using Document = std::variant<remesh::v1::FeatureModel, remesh::v1::ModelEdit>;

remesh::v1::ModelCheck ask(Session& session, const ValidateArguments& arguments,
                           Document document) {
  const auto fill = [&](remesh::v1::MeshOptions& options) {
    options = arguments.meshing.to_message();
    *options.mutable_fail_on() = arguments.meshing.warning_codes();
  };
  if (auto* model = std::get_if<remesh::v1::FeatureModel>(&document)) {
    remesh::v1::ValidateModelRequest request;
    *request.mutable_model() = std::move(*model);
    fill(*request.mutable_options());
    return session.client().validate(request, session.call());
  }
  remesh::v1::ValidateEditRequest request;
  *request.mutable_edit() = std::move(std::get<remesh::v1::ModelEdit>(document));
  fill(*request.mutable_options());
  Base base = resolve_base(session.documents(), arguments.base);
  if (auto* revision = std::get_if<std::string>(&base))
    request.set_base(*revision);
  else
    *request.mutable_base_model() = std::move(std::get<remesh::v1::FeatureModel>(base));
  return session.client().validate(request, session.call());
}

/// What meshing the whole model would come to, and the smallest details that decide on it.
void add_forecast(const remesh::v1::MeshForecast& forecast,
                  std::vector<std::vector<std::string>>& rows) {
  constexpr int kShown = 5;
  constexpr double kMega = 1e6;
  rows.push_back({"nodes, about", std::to_string(forecast.nodes())});
  rows.push_back(
      {"memory, about", rounded(static_cast<double>(forecast.bytes()) / kMega, 3) + " MB"});
  rows.push_back({"time, about", rounded(forecast.seconds(), 2) + " s"});
  for (int k = 0; k < std::min(kShown, forecast.details_size()); ++k) {
    const auto& detail = forecast.details(k);
    rows.push_back(
        {k == 0 ? "shortest edges" : "", detail.face() + ": " + rounded(detail.size(), 3)});
  }
}

int validate(Session& session, const ValidateArguments& arguments) {
  check_one_stdin(arguments.file, arguments.base);
  // With a base it is an edit, whatever it says.
  Document document = arguments.base.empty()
                          ? read_either(session.documents(), arguments.file)
                          : Document(read_edit(session.documents(), arguments.file));
  if (std::holds_alternative<remesh::v1::ModelEdit>(document) && arguments.base.empty()) {
    session.console().note(Documents::shown(arguments.file) +
                           " is a well-formed edit; --base BASE checks it with its model");
    return kFine;
  }
  const auto check = in_document(session.documents(), arguments.file,
                                 [&] { return ask(session, arguments, std::move(document)); });
  show_warnings(session, check.warnings());
  if (!arguments.json.empty()) session.write_text(arguments.json, write_json(check));
  if (arguments.json == "-") return kFine;
  std::vector<std::vector<std::string>> rows{
      {"model", check.model().name()},
      {"features", std::to_string(check.model().features_size())},
      {"volume", exact(check.volume())},
      {"area", exact(check.area())},
      {"cells", std::to_string(check.cells())},
      {"faces", std::to_string(check.faces())},
      {"edges", std::to_string(check.edges())},
      {"vertices", std::to_string(check.vertices())}};
  if (check.has_forecast()) add_forecast(check.forecast(), rows);
  write_table(session.out(), rows);
  return kFine;
}

}  // namespace

void add_validate_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("validate", "Check a model or an edit without meshing");
  const auto arguments = std::make_shared<ValidateArguments>();
  command->add_option("FILE", arguments->file, "Model or edit document; `-`: stdin")->required();
  command
      ->add_option(
          "--base", arguments->base,
          "What FILE, an edit, is for: revision or model file; without it only its form is checked")
      ->type_name("BASE");
  arguments->meshing.add_mesh_to(*command);
  command->add_option("--json", arguments->json, "Write the findings here; `-`: to stdout")
      ->type_name("FILE");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) { return validate(session, *arguments); };
  });
}

}  // namespace remeshd::cli
