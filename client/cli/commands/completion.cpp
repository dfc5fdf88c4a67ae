#include "client/cli/completion.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/choice.h"
#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"

namespace remeshd::cli {

void add_completion_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "completion", "Write a script that completes commands and options in a shell");
  const auto shell = std::make_shared<std::string>();
  only(*command->add_option("SHELL", *shell, "For which shell")->required(),
       {"bash", "zsh", "fish"});
  command->callback([shell, &app, &action] {
    action = [shell, &app](Session& session) {
      session.write_text("-", *shell == "bash"  ? bash_completion(app)
                              : *shell == "zsh" ? zsh_completion(app)
                                                : fish_completion(app));
      return kFine;
    };
  });
}

}  // namespace remeshd::cli
