#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"

namespace remeshd::cli {
namespace {

void show_head(Session& session, const std::string& design, std::uint32_t number,
               const std::string& id) {
  session.out() << design << '@' << number << "  " << id << '\n';
}

int head(Session& session, const std::string& name, const std::string& revision) {
  const bool shows = revision.empty() && name.find('@') == std::string::npos;
  if (shows) {
    const auto found = session.client().get_revision(name, session.call()).revision();
    show_head(session, found.design(), found.number(), found.id());
    return kFine;
  }
  remesh::v1::SetHeadRequest request;
  request.set_revision(revision.empty() ? name : revision);
  if (!revision.empty()) request.set_design(name);
  const auto reply = session.client().set_head(request, session.call());
  show_head(session, reply.design().name(), reply.design().head_number(), reply.design().head());
  return kFine;
}

}  // namespace

void add_head_command(CLI::App& app, Action& action) {
  struct Arguments {
    std::string name, revision;
  };
  auto* command = app.add_subcommand("head", "Show the head of a design, or make it another one");
  const auto arguments = std::make_shared<Arguments>();
  command
      ->add_option("DESIGN[@N]", arguments->name,
                   "`DESIGN` shows its head; `DESIGN@N` makes that revision its head")
      ->required();
  command->add_option(
      "REV", arguments->revision,
      "Revision to become the head of DESIGN, which has it: its id or another name");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      return head(session, arguments->name, arguments->revision);
    };
  });
}

}  // namespace remeshd::cli
