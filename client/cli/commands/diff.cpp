#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "client/cli/base.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/model_changes.h"
#include "client/cli/table.h"
#include "client/cli/with_edit.h"
#include "proto/json_writer.h"

namespace remeshd::cli {
namespace {

struct DiffArguments {
  std::string original, modified, file;
};

remesh::v1::ModelChoice choice_of(Named named) {
  remesh::v1::ModelChoice choice;
  if (auto* revision = std::get_if<std::string>(&named))
    choice.set_revision(*revision);
  else if (auto* model = std::get_if<remesh::v1::FeatureModel>(&named))
    *choice.mutable_model() = std::move(*model);
  else
    *choice.mutable_edit() = std::move(std::get<remesh::v1::ModelEdit>(named));
  return choice;
}

template <class Classes>
void add_rows(std::vector<std::vector<std::string>>& rows, const std::string& feature,
              const std::string& part, const Classes& classes) {
  for (const auto& [name, amount] : std::map<std::string, double>(classes.begin(), classes.end()))
    rows.push_back({feature, part, name, exact(amount)});
}

void write_comparison(std::ostream& out, const remesh::v1::Comparison& comparison) {
  std::vector<std::vector<std::string>> rows{{"feature", "part", "class", "amount"}};
  for (const auto& feature : comparison.features()) {
    add_rows(rows, feature.id(), "cells", feature.cells());
    add_rows(rows, feature.id(), "faces", feature.faces());
    add_rows(rows, feature.id(), "edges", feature.edges());
    add_rows(rows, feature.id(), "vertices", feature.vertices());
  }
  write_table(out, rows);
  write_table(out, {{"copycells", exact(comparison.copycells())},
                    {"newcells", exact(comparison.newcells())},
                    {"method", comparison.method()},
                    {"error bound", exact(comparison.error_bound())}});
}

remesh::v1::FeatureModel model_of(Session& session, const remesh::v1::ModelChoice& choice) {
  if (choice.has_model()) return choice.model();
  return session.client().get_revision(choice.revision(), session.call()).model();
}

/// What differs in the documents, before what that does to the geometry.
void write_changes(Session& session, const remesh::v1::CompareRequest& request) {
  const auto before = model_of(session, request.original());
  const auto& modified = request.modified();
  const auto after =
      modified.has_edit() ? with_edit(before, modified.edit()) : model_of(session, modified);
  write_table(session.out(), {{"changes", changes_in_words(before, after)}});
}

int diff(Session& session, const DiffArguments& arguments) {
  check_one_stdin(arguments.original, arguments.modified);
  remesh::v1::CompareRequest request;
  *request.mutable_original() = choice_of(resolve(session.documents(), arguments.original));
  if (request.original().has_edit())
    throw UsageError(Documents::shown(arguments.original) +
                     " is an edit; only the second side may be one");
  *request.mutable_modified() = choice_of(resolve(session.documents(), arguments.modified));
  const auto comparison = session.client().compare(request, session.call());
  if (!arguments.file.empty()) session.write_text(arguments.file, write_json(comparison));
  if (arguments.file != "-") {
    write_changes(session, request);
    write_comparison(session.out(), comparison);
  }
  return kFine;
}

}  // namespace

void add_diff_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("diff", "What changes from one model to another, by feature");
  const auto arguments = std::make_shared<DiffArguments>();
  command->add_option("A", arguments->original, "Revision or model file")->required();
  command->add_option("B", arguments->modified, "Revision, model file or edit file")->required();
  command->add_option("--json", arguments->file, "Write the comparison here; `-`: to stdout")
      ->type_name("FILE");
  command->footer(
      "Classes of cells: ++ +- -+ -- .+ .- +. -. (original, modified; + material, - void, . not in "
      "the model); of faces, edges and vertices: bb nn nb bn .b .n b. n. (b boundary, n not).");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) { return diff(session, *arguments); };
  });
}

}  // namespace remeshd::cli
