#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "client/cli/base.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/mesh_base.h"
#include "client/cli/mesh_options.h"
#include "client/cli/reply.h"
#include "client/cli/short_edits.h"
#include "client/cli/table.h"
#include "client/cli/warnings.h"
#include "proto/json_writer.h"

namespace remeshd::cli {
namespace {

struct SweepArguments {
  std::string base, parameter, folder;
  std::string format = "vtu";
  double from = 0, to = 0;
  int steps = 0;
  bool from_base = false;
  MeshingOptions meshing;
};

/// Values are spread evenly, both ends included; a single step takes the first.
double value_of(const SweepArguments& arguments, int step) {
  if (step == 0) return arguments.from;
  if (step == arguments.steps - 1) return arguments.to;
  return arguments.from + (arguments.to - arguments.from) * step / (arguments.steps - 1);
}

client::CallError unknown_parameter(const std::string& name) {
  remesh::v1::Error error;
  error.set_code(remesh::v1::Error::CODE_INVALID_ARGUMENT);
  error.set_reason(remesh::v1::Error::UNKNOWN_PARAMETER);
  error.set_message("the model has no parameter '" + name + "' to sweep");
  error.set_stage("request");
  error.set_hint("PARAMETER is a parameter of the model, or feature.parameter");
  return client::CallError(std::move(error));
}

/// A wrong name would fail in every step: it is told before the first.
void check_parameter(const remesh::v1::FeatureModel& model, const std::string& parameter) {
  const std::size_t dot = parameter.find('.');
  const bool known =
      dot == std::string::npos
          ? std::ranges::any_of(
                model.parameters(),
                [&](const remesh::v1::Parameter& one) { return one.name() == parameter; })
          : std::ranges::any_of(model.features(), [&](const remesh::v1::Feature& feature) {
              return feature.id() == parameter.substr(0, dot);
            });
  if (!known) throw unknown_parameter(parameter);
}

/// The id of the revision to start from, which is meshed first where the base is a model.
std::string start(Session& session, client::EditStream& stream, const Base& base,
                  const SweepArguments& arguments) {
  if (const auto* model = std::get_if<remesh::v1::FeatureModel>(&base)) {
    check_parameter(*model, arguments.parameter);
    return mesh_base(session, stream, base, arguments.meshing);
  }
  const auto description =
      session.client().get_revision(std::get<std::string>(base), session.call());
  check_parameter(description.model(), arguments.parameter);
  return description.revision().id();
}

remesh::v1::ModelEdit edit_of(const std::string& parameter, double value) {
  remesh::v1::ModelEdit edit;
  google::protobuf::Value number;
  number.set_number_value(value);
  add_set_parameter(edit, parameter, std::move(number));
  return edit;
}

std::vector<std::string> row_of(const remesh::v1::RevisionResult& reply) {
  const remesh::v1::Report& report = reply.report();
  const auto& quality = report.quality();
  return {"ok",
          reply.revision().id(),
          std::to_string(report.nodes()),
          std::to_string(report.tets()),
          std::to_string(report.nodes_kept()),
          std::to_string(report.tets_kept()),
          exact(report.free_share()),
          exact(report.volume()),
          exact(report.exact_volume()),
          exact(quality.volume_length_mean()),
          exact(quality.volume_length_min()),
          exact(quality.dihedral_min()),
          exact(report.seconds().total()),
          report.cached() ? "true" : "false",
          ""};
}

const std::vector<std::string> kHeading{"step",
                                        "value",
                                        "status",
                                        "revision",
                                        "nodes",
                                        "tets",
                                        "nodes_kept",
                                        "tets_kept",
                                        "free_share",
                                        "volume",
                                        "exact_volume",
                                        "volume_length_mean",
                                        "volume_length_min",
                                        "dihedral_min",
                                        "seconds",
                                        "cached",
                                        "error"};

std::vector<std::string> row_of(const client::CallError& error) {
  std::vector<std::string> row(kHeading.size() - 2);
  row.front() = client::reason_name(error.detail());
  row.back() = error.what();
  return row;
}

/// Failures after which the next step cannot fare better: nobody is there, or nobody may.
bool is_final(const client::CallError& error) {
  const ExitCode code = exit_code(error.detail());
  return code == kUnreachable || code == kDenied;
}

std::string file_name(int step, int steps, const std::string& ending) {
  const std::string number = std::to_string(step);
  const std::size_t width = std::to_string(steps).size();
  return "step-" + std::string(width - number.size(), '0') + number + ending;
}

void write_files(Session& session, const SweepArguments& arguments, int step,
                 const remesh::v1::RevisionResult& reply) {
  const std::filesystem::path folder = arguments.folder;
  session.write_mesh_of(
      reply.revision().id(),
      {.files = {folder / file_name(step, arguments.steps, "." + arguments.format)}, .format = {}});
  session.write_text(folder / file_name(step, arguments.steps, ".json"),
                     write_json(reply.report()));
}

/// Sends the edit of one step. Where no design is named it is to be filed in none; a daemon that
/// cannot do that files it like any other, and is not asked again.
remesh::v1::RevisionResult remesh_step(client::EditStream& stream,
                                       remesh::v1::EditRevisionRequest request, bool& unfiled) {
  if (unfiled) request.mutable_head()->set_file(false);
  try {
    return stream.edit(request).get();
  } catch (const client::CallError& error) {
    if (!unfiled || error.reason() != remesh::v1::Error::UNSUPPORTED) throw;
  }
  unfiled = false;
  request.mutable_head()->clear_file();
  return stream.edit(std::move(request)).get();
}

int sweep(Session& session, const SweepArguments& arguments) {
  if (!arguments.folder.empty()) {
    std::error_code problem;
    std::filesystem::create_directories(arguments.folder, problem);
    if (problem) throw UsageError(arguments.folder + ": " + problem.message());
  }
  const Base base = resolve_base(session.documents(), arguments.base);
  client::EditStream stream = session.stream();
  const std::string first = start(session, stream, base, arguments);
  const bool base_is_model = std::holds_alternative<remesh::v1::FeatureModel>(base);
  std::string previous = first;
  int failures = 0;
  bool unfiled = arguments.meshing.design.empty();
  write_tsv_row(session.out(), kHeading);
  session.check_output();
  for (int step = 0; step < arguments.steps; ++step) {
    const double value = value_of(arguments, step);
    remesh::v1::EditRevisionRequest request;
    request.set_base(arguments.from_base ? first : previous);
    *request.mutable_edit() = edit_of(arguments.parameter, value);
    arguments.meshing.fill(request, !base_is_model);
    std::vector<std::string> row{std::to_string(step + 1), exact(value)};
    std::vector<std::string> rest;
    try {
      const auto reply = remesh_step(stream, std::move(request), unfiled);
      session.console().end_progress();
      show_warnings(session, reply.report().warnings(), " (step " + row.front() + ")");
      if (!arguments.folder.empty()) write_files(session, arguments, step + 1, reply);
      previous = reply.revision().id();
      rest = row_of(reply);
    } catch (const client::CallError& error) {
      session.poll();
      if (is_final(error)) throw;
      ++failures;
      session.console().error("step " + row.front() + ": " + error.what());
      rest = row_of(error);
    }
    row.insert(row.end(), rest.begin(), rest.end());
    write_tsv_row(session.out(), row);
    session.check_output();
  }
  stream.finish();
  return failures == 0 ? kFine : kFailed;
}

}  // namespace

void add_sweep_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "sweep", "Remesh for each of STEPS values of a parameter, from FROM to TO, over one stream");
  const auto arguments = std::make_shared<SweepArguments>();
  command->add_option("BASE", arguments->base, "Revision or model file")->required();
  command
      ->add_option("PARAMETER", arguments->parameter,
                   "Parameter of the model, or feature.parameter")
      ->required();
  const auto finite = CLI::Validator(
      [](const std::string& text) {
        double value = 0;
        const bool fine = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
        return fine ? std::string() : text + " is no finite number";
      },
      "", "");
  command->add_option("FROM", arguments->from, "First value")->required()->check(finite);
  command->add_option("TO", arguments->to, "Last value")->required()->check(finite);
  command->add_option("STEPS", arguments->steps, "Number of values")
      ->required()
      ->check(CLI::Range(1, 1'000'000));
  command
      ->add_option("-o,--output", arguments->folder,
                   "Write each step's mesh and Report into this folder")
      ->type_name("DIR");
  command->add_option("--format", arguments->format, "Format of the meshes: vtu, msh or inp [vtu]")
      ->check(CLI::IsMember({"vtu", "msh", "inp"}));
  command->add_flag("--from-base", arguments->from_base,
                    "Let every step edit BASE, not the last step that went well");
  arguments->meshing.add_to(*command);
  command->footer(
      "Prints a line for each step, tabs between the columns. A step that fails is told in its "
      "line and the sweep goes on; the exit code is then 4. No head is moved, and where the daemon "
      "can, the revisions are in no design unless --design names one.");
  command->callback([arguments, &action] {
    arguments->meshing.keep_head = true;
    action = [arguments](Session& session) { return sweep(session, *arguments); };
  });
}

}  // namespace remeshd::cli
