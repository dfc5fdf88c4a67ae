#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/reply.h"
#include "client/cli/table.h"

namespace remeshd::cli {
namespace {

using remesh::v1::Report;
using Rows = std::vector<std::vector<std::string>>;

/// 0, for a step of which the daemon tells no seconds, is `-`.
std::string seconds(double value) {
  if (value <= 0) return "-";
  return value < 0.001 ? "<0.001" : rounded(value, 3);
}

void add_attempt(const Report::Attempt& attempt, const std::string& step, Rows& rows) {
  rows.push_back(
      {step, attempt.strategy(), "given up", seconds(attempt.seconds()), attempt.reason()});
}

/// Rows for the strategies that were given up, the one that made the mesh, and a renewal that was
/// given up, since that is tried once there is a mesh.
void add_mesh(const Report& report, Rows& rows) {
  const std::string renewed = way_name(Report::WAY_RENEWED);
  for (const Report::Attempt& attempt : report.attempts())
    if (attempt.strategy() != renewed) add_attempt(attempt, "mesh", rows);
  const Report::Attempt& taken = report.diagnostics().taken();
  rows.push_back({"mesh", taken.strategy().empty() ? way_name(report.way()) : taken.strategy(),
                  "taken", seconds(taken.seconds()), "-"});
  for (const Report::Attempt& attempt : report.attempts())
    if (attempt.strategy() == renewed) add_attempt(attempt, "mesh", rows);
}

/// The road that a revision took: what made its boundary and its mesh, and what was tried besides.
int explain(Session& session, const std::string& name) {
  const auto description = session.client().get_revision(name, session.call());
  const auto& revision = description.revision();
  const Report& report = description.report();
  const auto& diagnostics = report.diagnostics();
  write_table(session.out(),
              {{"revision", short_name(revision)},
               {revision.parent().empty() ? "first mesh of" : "edit of",
                revision.parent().empty() ? revision.model_name() : revision.parent()},
               {"seconds", rounded(report.seconds().total(), 3)}});
  Rows rows{{"step", "way", "outcome", "seconds", "reason"}};
  for (const Report::Attempt& attempt : diagnostics.geometry_attempts())
    add_attempt(attempt, "boundary", rows);
  rows.push_back({"boundary", diagnostics.geometry().empty() ? "-" : diagnostics.geometry(),
                  "taken", seconds(diagnostics.geometry_seconds()), "-"});
  add_mesh(report, rows);
  session.out() << '\n';
  write_table(session.out(), rows);
  return kFine;
}

}  // namespace

void add_explain_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "explain", "Show which way a revision's boundary and mesh came about, and why not another");
  const auto revision = std::make_shared<std::string>();
  command->add_option("REV", *revision, "Revision")->required();
  command->callback([revision, &action] {
    action = [revision](Session& session) { return explain(session, *revision); };
  });
}

}  // namespace remeshd::cli
