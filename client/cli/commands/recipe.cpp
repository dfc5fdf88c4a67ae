#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/reply.h"

namespace remeshd::cli {
namespace {

void add_recipe(CLI::App& app, Action& action) {
  struct Arguments {
    std::string revision, file = "-";
  };
  auto* command = app.add_subcommand("recipe", "Write what a revision is made of again, as JSON");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("REV", arguments->revision, "Revision; its mesh may have gone")->required();
  command->add_option("-o,--output", arguments->file, "Recipe; `-`, the default: to stdout")
      ->type_name("FILE");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      check_text_file(arguments->file);
      const auto reply = session.client().get_recipe(arguments->revision, session.call());
      session.write_text(arguments->file, reply.document());
      return kFine;
    };
  });
}

void add_remake(CLI::App& app, Action& action) {
  struct Arguments {
    std::string revision, design;
    bool head = false;
  };
  auto* command = app.add_subcommand(
      "remake", "Make a new revision of a recipe with the algorithm that the daemon has today");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("REV", arguments->revision, "Revision; its mesh may have gone")->required();
  command->add_option("--design", arguments->design, "Design that gets it [that of REV]");
  command->add_flag("--head", arguments->head,
                    "It becomes the head of the design; else only where REV is the head");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      remesh::v1::RemakeRevisionRequest request;
      request.set_revision(arguments->revision);
      request.set_design(arguments->design);
      if (arguments->head) request.mutable_head()->set_advance(true);
      const auto reply = session.client().remake_revision(request, session.call());
      for (const std::string& id : reply.remade())
        session.console().note("made anew for it: " + id.substr(0, 12));
      note_head_conflict(session, reply.result(), "another one became it meanwhile");
      const auto& revision = reply.result().revision();
      session.out() << short_name(revision) << "  " << revision.id() << '\n';
      return kFine;
    };
  });
}

}  // namespace

void add_recipe_commands(CLI::App& app, Action& action) {
  add_recipe(app, action);
  add_remake(app, action);
}

}  // namespace remeshd::cli
