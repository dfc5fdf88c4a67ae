#include "client/cli/help_examples.h"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace remeshd::cli {
namespace {

struct HelpExamples {
  std::vector<std::string> command;  ///< names from the top down; none: `remesh` itself
  std::vector<std::string> lines;
};

const std::vector<HelpExamples> kHelpExamples{
    {{},
     {"remesh example bracket -o bracket.json", "remesh mesh bracket.json --local -o bracket.vtu",
      "remesh edit bracket --set wall=8 --remove rib --local -o thin.vtu"}},
    {{"mesh"},
     {"remesh mesh part.json -o part.vtu", "remesh mesh part.json --size 2.5 --order 2 -o part.inp",
      "remesh mesh - -o - --format msh < part.json > part.msh"}},
    {{"edit"},
     {"remesh edit bracket --set wall=8 --set hole.radius=9 --remove rib -o thin.vtu",
      "remesh edit bracket@2 thinner.json --fail-on GROUP_EMPTIED -o thin.msh --json "
      "report.json"}},
    {{"sweep"},
     {"remesh sweep bracket wall 6 10 5 -o steps",
      "remesh sweep part.json --set wall=6:10:5 --set hole.radius=8,9,10 > table.tsv"}},
    {{"diff"}, {"remesh diff bracket@1 bracket@2", "remesh diff part.json thinner.json --json -"}},
    {{"validate"},
     {"remesh validate part.json --size 2", "remesh validate thinner.json --base bracket"}},
    {{"example"}, {"remesh example", "remesh example bracket -o bracket.json"}},
    {{"schema"}, {"remesh schema model -o model.schema.json", "remesh schema edit"}},
    {{"model"}, {"remesh model bracket@2 -o part.json"}},
    {{"log"}, {"remesh log bracket --changes"}},
    {{"revisions"}, {"remesh revisions --json -"}},
    {{"get"},
     {"remesh get bracket -o part.vtu -o part.inp", "remesh get bracket@2 -o - --format msh"}},
    {{"rm"}, {"remesh rm bracket@2", "remesh rm --design bracket"}},
    {{"blame"}, {"remesh blame bracket rib.top", "remesh blame bracket@3 4711"}},
    {{"explain"}, {"remesh explain bracket"}},
    {{"report"},
     {"remesh report bracket@1 bracket -o report.html", "remesh report bracket -o report.html"}},
    {{"head"}, {"remesh head bracket", "remesh head bracket@2"}},
    {{"recipe"}, {"remesh recipe bracket@2 -o recipe.json"}},
    {{"remake"}, {"remesh remake bracket@2 --head"}},
    {{"cache"}, {"remesh cache ls --by bytes", "remesh cache verify --repair"}},
    {{"cache", "ls"}, {"remesh cache ls --by bytes --reverse"}},
    {{"cache", "stat"}, {"remesh cache stat"}},
    {{"cache", "gc"}, {"remesh cache gc --disk 500 --dry-run"}},
    {{"cache", "verify"}, {"remesh cache verify --repair"}},
    {{"cache", "pin"}, {"remesh cache pin bracket@1", "remesh cache pin --off bracket@1"}},
    {{"quality"}, {"remesh quality part.msh --exact-volume 172863.7158"}},
    {{"types"}, {"remesh types"}},
    {{"info"}, {"remesh info --address 127.0.0.1:50051"}},
    {{"completion"},
     {"remesh completion bash > ~/.local/share/bash-completion/completions/remesh",
      "remesh completion fish > ~/.config/fish/completions/remesh.fish"}},
};

}  // namespace

void add_help_examples(CLI::App& app) {
  for (const HelpExamples& of : kHelpExamples) {
    CLI::App* command = &app;
    for (const std::string& name : of.command) command = command->get_subcommand(name);
    std::string text = command->get_footer();
    if (!text.empty()) text += "\n\n";
    text += of.lines.size() == 1 ? "Example:" : "Examples:";
    for (const std::string& line : of.lines) text += "\n  " + line;
    command->footer(text);
  }
}

}  // namespace remeshd::cli
