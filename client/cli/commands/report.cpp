#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <set>

#include "client/cli/base.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/report/page.h"

namespace remeshd::cli {
namespace {

struct ReportArguments {
  std::vector<std::string> revisions;  ///< NEW, or BASE and NEW
  std::string file;
  bool surfaces_only = false;
};

bool is_unknown(const client::CallError& error) {
  return error.detail().code() == remesh::v1::Error::CODE_NOT_FOUND;
}

void check_revision_name(Session& session, const std::string& name) {
  if (!std::holds_alternative<std::string>(resolve(session.documents(), name)))
    throw UsageError(Documents::shown(name) +
                     " is a file; a report is about revisions: mesh it first");
}

ReportSide read_side(Session& session, const std::string& name) {
  ReportSide side;
  side.about = session.client().get_revision(name, session.call());
  side.mesh = session.client().get_mesh(side.about.revision().id(), session.call());
  session.poll();
  return side;
}

/// Follows the parents of `modified` to `base`.
Descent descent_from(Session& session, const remesh::v1::RevisionInfo& base,
                     const remesh::v1::RevisionInfo& modified) {
  std::string parent = modified.parent();
  if (!parent.empty() && parent == base.id()) return Descent::Parent;
  std::set<std::string> seen{modified.id()};
  while (!parent.empty() && seen.insert(parent).second) {
    if (parent == base.id()) return Descent::Ancestor;
    try {
      parent = session.client().get_revision(parent, session.call()).revision().parent();
    } catch (const client::CallError& error) {
      if (!is_unknown(error)) throw;
      return Descent::None;
    }
  }
  return Descent::None;
}

/// The parent of the revision that the report is about, where it has one that is still there.
std::optional<ReportSide> read_parent(Session& session, const remesh::v1::RevisionInfo& modified) {
  if (modified.parent().empty()) return {};
  try {
    return read_side(session, modified.parent());
  } catch (const client::CallError& error) {
    if (!is_unknown(error)) throw;
    session.console().note("the parent of this revision is no more; the report is about it alone");
    return {};
  }
}

int report(Session& session, const ReportArguments& arguments) {
  check_text_file(arguments.file);
  for (const std::string& name : arguments.revisions) check_revision_name(session, name);
  ReportContent content;
  content.surfaces_only = arguments.surfaces_only;
  content.modified = read_side(session, arguments.revisions.back());
  const auto& modified = content.modified.about.revision();
  if (arguments.revisions.size() == 2)
    content.base = read_side(session, arguments.revisions.front());
  else
    content.base = read_parent(session, modified);
  if (content.base)
    content.descent = descent_from(session, content.base->about.revision(), modified);
  session.write_text(arguments.file, report_page(content));
  if (has_surfaces_only(content) && !content.surfaces_only)
    session.console().note("more than " + std::to_string(kMostTetsInside) +
                           " tets: the page has only surfaces and the worst tets");
  session.console().detail("wrote " + arguments.file);
  return kFine;
}

}  // namespace

void add_report_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "report", "Write one HTML page on what an edit did: figures, both meshes in 3-D");
  const auto arguments = std::make_shared<ReportArguments>();
  command
      ->add_option("REV", arguments->revisions,
                   "[BASE] NEW: revisions; without BASE the parent of NEW, or NEW alone where it "
                   "has none")
      ->required()
      ->expected(1, 2);
  command->add_option("-o,--output", arguments->file, "The page; `-`: to stdout")
      ->required()
      ->type_name("FILE");
  command->add_flag("--surfaces", arguments->surfaces_only,
                    "Leave the interior of the meshes out, as is done above 300,000 tets");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) { return report(session, *arguments); };
  });
}

}  // namespace remeshd::cli
