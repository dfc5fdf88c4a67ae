#pragma once

#include <functional>

#include "client/cli/session.h"

namespace CLI {
class App;
}

namespace remeshd::cli {

/// What a command does once the command line is understood; returns the exit code.
using Action = std::function<int(Session&)>;

// Each adds its commands to the command line; the one that is chosen sets `action`.
void add_mesh_command(CLI::App& app, Action& action);
void add_edit_command(CLI::App& app, Action& action);
void add_sweep_command(CLI::App& app, Action& action);
void add_diff_command(CLI::App& app, Action& action);
void add_validate_command(CLI::App& app, Action& action);
void add_example_command(CLI::App& app, Action& action);
void add_schema_command(CLI::App& app, Action& action);
void add_revision_commands(CLI::App& app, Action& action);  ///< model, log, revisions, get, rm
void add_blame_command(CLI::App& app, Action& action);
void add_explain_command(CLI::App& app, Action& action);
void add_report_command(CLI::App& app, Action& action);
void add_head_command(CLI::App& app, Action& action);
void add_recipe_commands(CLI::App& app, Action& action);  ///< recipe, remake
void add_cache_command(CLI::App& app, Action& action);
void add_quality_command(CLI::App& app, Action& action);
void add_types_command(CLI::App& app, Action& action);
void add_info_command(CLI::App& app, Action& action);
void add_completion_command(CLI::App& app, Action& action);

}  // namespace remeshd::cli
