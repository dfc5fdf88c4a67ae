#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "client/cli/base.h"
#include "client/cli/choice.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/in_document.h"
#include "client/cli/mesh_base.h"
#include "client/cli/mesh_options.h"
#include "client/cli/reply.h"
#include "client/cli/short_edits.h"
#include "client/cli/sweep_grid.h"
#include "client/cli/table.h"
#include "client/cli/warnings.h"
#include "engine/base/text/nearest_name.h"
#include "proto/json_writer.h"
#include "remeshd/mesh_file.h"

namespace remeshd::cli {
namespace {

struct SweepArguments {
  std::string base, parameter, folder;
  std::string format = "vtu";
  std::optional<double> from, to;
  std::optional<int> steps;
  std::vector<std::string> sets;      ///< in place of parameter, from, to and steps
  std::vector<SweptParameter> swept;  ///< from whichever is given
  bool from_base = false;
  MeshingOptions meshing;
};

/// What the options mean together. Throws CLI::RequiredError, CLI::ExcludesError, UsageError.
void settle(SweepArguments& arguments) {
  if (arguments.sets.empty()) {
    if (!arguments.steps) throw CLI::RequiredError("PARAMETER FROM TO STEPS, or --set,");
    arguments.swept = {
        {arguments.parameter, evenly_spread(*arguments.from, *arguments.to, *arguments.steps)}};
    return;
  }
  if (!arguments.parameter.empty()) throw CLI::ExcludesError("PARAMETER", "--set");
  for (const std::string& set : arguments.sets) arguments.swept.push_back(parse_swept(set));
}

client::CallError unknown_parameter(const std::string& name,
                                    const std::vector<std::string>& known) {
  remesh::v1::Error error;
  error.set_code(remesh::v1::Error::CODE_INVALID_ARGUMENT);
  error.set_reason(remesh::v1::Error::UNKNOWN_PARAMETER);
  error.set_message("the model has no parameter '" + name + "' to sweep" + suggestion(name, known));
  error.set_stage("request");
  error.set_hint("what is swept is a parameter of the model, or feature.parameter");
  return client::CallError(std::move(error));
}

/// Throws before the first step for a name that would fail in every step. Whether a feature has a
/// parameter that its document leaves out, the daemon knows.
void check_parameters(const remesh::v1::FeatureModel& model,
                      const std::vector<SweptParameter>& swept) {
  std::vector<std::string> known, features;
  for (const remesh::v1::Parameter& parameter : model.parameters())
    known.push_back(parameter.name());
  for (const remesh::v1::Feature& feature : model.features()) {
    features.push_back(feature.id());
    for (const remesh::v1::FeatureParameter& parameter : feature.parameters())
      known.push_back(feature.id() + "." + parameter.name());
  }
  for (const SweptParameter& each : swept) {
    const std::size_t dot = each.name.find('.');
    const bool of_feature = dot != std::string::npos &&
                            std::ranges::find(features, each.name.substr(0, dot)) != features.end();
    if (!of_feature && std::ranges::find(known, each.name) == known.end())
      throw unknown_parameter(each.name, known);
  }
}

/// The id of the revision to start from, which is meshed first where the base is a model.
std::string start(Session& session, client::EditStream& stream, const Base& base,
                  const SweepArguments& arguments) {
  if (const auto* model = std::get_if<remesh::v1::FeatureModel>(&base)) {
    check_parameters(*model, arguments.swept);
    return mesh_base(session, stream, base, arguments.meshing).revision;
  }
  const auto description =
      session.client().get_revision(std::get<std::string>(base), session.call());
  check_parameters(description.model(), arguments.swept);
  return description.revision().id();
}

/// Sets all that is swept: the revision edited is not always that of the step before.
remesh::v1::ModelEdit edit_of(const std::vector<SweptParameter>& swept,
                              const std::vector<double>& values) {
  remesh::v1::ModelEdit edit;
  for (std::size_t k = 0; k < swept.size(); ++k) {
    google::protobuf::Value number;
    number.set_number_value(values[k]);
    add_set_parameter(edit, swept[k].name, std::move(number));
  }
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

/// Names of the columns of `row_of`.
const std::vector<std::string> kHeading{"status",
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

/// A single parameter's column is `value`, as it always was; several have their names.
std::vector<std::string> heading_of(const SweepArguments& arguments) {
  std::vector<std::string> heading{"step"};
  if (arguments.sets.empty())
    heading.emplace_back("value");
  else
    for (const SweptParameter& swept : arguments.swept) heading.push_back(swept.name);
  heading.insert(heading.end(), kHeading.begin(), kHeading.end());
  return heading;
}

std::vector<std::string> row_of(const client::CallError& error) {
  std::vector<std::string> row(kHeading.size());
  row.front() = client::reason_name(error.detail());
  row.back() = error.what();
  return row;
}

/// Failures after which the next step cannot fare better: nobody is there, or nobody may.
bool is_final(const client::CallError& error) {
  const ExitCode code = exit_code(error.detail());
  return code == kUnreachable || code == kDenied;
}

std::string file_name(std::uint64_t step, std::uint64_t steps, const std::string& ending) {
  const std::string number = std::to_string(step);
  const std::size_t width = std::to_string(steps).size();
  return "step-" + std::string(width - number.size(), '0') + number + ending;
}

void write_files(Session& session, const SweepArguments& arguments, std::uint64_t step,
                 const remesh::v1::RevisionResult& reply) {
  const std::filesystem::path folder = arguments.folder;
  const std::uint64_t steps = count_combinations(arguments.swept);
  session.write_mesh_of(reply.revision().id(),
                        {.files = {folder / file_name(step, steps, "." + arguments.format)}});
  session.write_text(folder / file_name(step, steps, ".json"), write_json(reply.report()));
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

void make_folder(const std::string& folder) {
  if (folder.empty()) return;
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw client::FileError(folder + ": " + problem.message());
}

/// The state of a sweep between its steps.
struct Sweep {
  const SweepArguments& arguments;
  client::EditStream stream;
  std::string first, previous;  ///< ids: where it began, what the last step that went well made
  bool base_is_model = false;
  bool unfiled = false;  ///< its revisions are to be in no design
  int failures = 0;
};

/// Makes one revision and its files; returns its row.
std::vector<std::string> make_step(Session& session, Sweep& sweep, std::uint64_t step,
                                   const std::vector<double>& values) {
  const SweepArguments& arguments = sweep.arguments;
  const std::string number = std::to_string(step + 1);
  remesh::v1::EditRevisionRequest request;
  request.set_base(arguments.from_base ? sweep.first : sweep.previous);
  *request.mutable_edit() = edit_of(arguments.swept, values);
  arguments.meshing.fill(request, !sweep.base_is_model);
  try {
    const auto reply = remesh_step(sweep.stream, std::move(request), sweep.unfiled);
    session.console().end_progress();
    show_warnings(session, reply.report().warnings(), " (step " + number + ")");
    if (!arguments.folder.empty()) write_files(session, arguments, step + 1, reply);
    sweep.previous = reply.revision().id();
    return row_of(reply);
  } catch (const client::CallError& error) {
    session.poll();
    if (is_final(error)) throw;
    ++sweep.failures;
    session.console().error("step " + number + ": " + error.what());
    return row_of(error);
  }
}

int sweep_all(Session& session, const SweepArguments& arguments) {
  const std::uint64_t steps = count_combinations(arguments.swept);
  make_folder(arguments.folder);
  const Base base = resolve_base(session.documents(), arguments.base);
  Sweep sweep{.arguments = arguments, .stream = session.stream(), .first = {}, .previous = {}};
  sweep.first = in_document(session.documents(), arguments.base,
                            [&] { return start(session, sweep.stream, base, arguments); });
  sweep.previous = sweep.first;
  sweep.base_is_model = std::holds_alternative<remesh::v1::FeatureModel>(base);
  sweep.unfiled = arguments.meshing.design.empty();
  write_tsv_row(session.out(), heading_of(arguments));
  session.check_output();
  for (std::uint64_t step = 0; step < steps; ++step) {
    const std::vector<double> values = combination(arguments.swept, step);
    std::vector<std::string> row{std::to_string(step + 1)};
    for (const double value : values) row.push_back(exact(value));
    const auto rest = make_step(session, sweep, step, values);
    row.insert(row.end(), rest.begin(), rest.end());
    write_tsv_row(session.out(), row);
    session.check_output();
  }
  sweep.stream.finish();
  return sweep.failures == 0 ? kFine : kFailed;
}

}  // namespace

void add_sweep_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "sweep",
      "Remesh for each of STEPS values of a parameter, from FROM to TO, or for all combinations of "
      "several, over one stream");
  const auto arguments = std::make_shared<SweepArguments>();
  command->add_option("BASE", arguments->base, "Revision or model file")->required();
  auto* parameter = command->add_option("PARAMETER", arguments->parameter,
                                        "Parameter of the model, or feature.parameter");
  const auto finite = CLI::Validator(
      [](const std::string& text) {
        double value = 0;
        const bool fine = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
        return fine ? std::string() : text + " is no finite number";
      },
      "", "");
  command->add_option("FROM", arguments->from, "First value")->check(finite);
  command->add_option("TO", arguments->to, "Last value")->check(finite);
  command->add_option("STEPS", arguments->steps, "Number of values")
      ->check(CLI::Range(1, 1'000'000));
  command
      ->add_option("--set", arguments->sets,
                   "Sweep a parameter over FROM:TO:STEPS or over the values listed; given several "
                   "times: over all combinations, of which neighbours differ by one step")
      ->type_name("NAME=VALUES")
      ->expected(1)
      ->take_all()
      ->excludes(parameter);
  command
      ->add_option("-o,--output", arguments->folder,
                   "Write each step's mesh and Report into this folder")
      ->type_name("DIR");
  only(*command->add_option("--format", arguments->format, "Format of the files [vtu]"),
       file_formats());
  command->add_flag("--from-base", arguments->from_base,
                    "Let every step edit BASE, not the last step that went well");
  arguments->meshing.add_to(*command, MeshingOptions::Unset::OfBase);
  command->footer(
      "Prints a line for each step, tabs between the columns. A step that fails is told in its "
      "line and the sweep goes on; the exit code is then 4. No head is moved, and where the daemon "
      "can, the revisions are in no design unless --design names one. Options of the mesh that are "
      "left out are BASE's.");
  command->callback([arguments, &action] {
    arguments->meshing.keep_head = true;
    settle(*arguments);
    action = [arguments](Session& session) { return sweep_all(session, *arguments); };
  });
}

}  // namespace remeshd::cli
