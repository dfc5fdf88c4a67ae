#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "client/cli/choice.h"
#include "client/cli/commands/command.h"
#include "client/cli/embedded.h"
#include "client/cli/exit_code.h"
#include "client/cli/table.h"

namespace remeshd::cli {
namespace {

struct ExampleWords {
  std::string_view name, what;
};

/// One for each of `example_files`.
constexpr std::array kExampleWords{
    ExampleWords{"bracket", "plate with a back, a rib and a pipe; five parameters with bounds"},
    ExampleWords{"bracket.edit", "edit of bracket: thinner back, other hole, no rib"},
    ExampleWords{"mount", "mount with gussets and small holes, finer than an even edge length"},
    ExampleWords{"plate", "plate with a hole, fine at the hole"},
};

std::string_view words_about(std::string_view name) {
  const auto* found = std::ranges::find(kExampleWords, name, &ExampleWords::name);
  return found == kExampleWords.end() ? "" : found->what;
}

std::string_view text_of(const std::vector<EmbeddedText>& files, std::string_view name) {
  return std::ranges::find(files, name, &EmbeddedText::name)->text;
}

std::vector<std::string> names_of(const std::vector<EmbeddedText>& files) {
  std::vector<std::string> names;
  for (const EmbeddedText& file : files) names.emplace_back(file.name);
  std::ranges::sort(names);
  return names;
}

void list_examples(std::ostream& out) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& name : names_of(example_files()))
    rows.push_back({name, std::string(words_about(name))});
  write_table(out, rows);
}

/// The schema as one document: that of edits refers to definitions in that of models, which are
/// copied into it.
std::string schema_text(const std::string& name) {
  std::string text(text_of(schema_files(), name));
  if (name == "model") return text;
  const std::string other = "model.schema.json#";
  for (std::size_t at = text.find(other); at != std::string::npos; at = text.find(other, at))
    text.replace(at, other.size(), "#");
  auto schema = nlohmann::ordered_json::parse(text);
  const auto model = nlohmann::ordered_json::parse(text_of(schema_files(), "model"));
  for (const auto& [key, definition] : model["$defs"].items()) schema["$defs"][key] = definition;
  return schema.dump(2) + "\n";
}

void add_output(CLI::App& command, std::string& file) {
  command.add_option("-o,--output", file, "File to write; `-`, the default: to stdout")
      ->type_name("FILE");
}

}  // namespace

void add_example_command(CLI::App& app, Action& action) {
  struct Arguments {
    std::string name, file = "-";
  };
  auto* command =
      app.add_subcommand("example", "Write a document to begin with; without a name: list them");
  const auto arguments = std::make_shared<Arguments>();
  only(*command->add_option("NAME", arguments->name, "Which one"), names_of(example_files()));
  add_output(*command, arguments->file);
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      check_text_file(arguments->file);
      if (arguments->name.empty())
        list_examples(session.out());
      else
        session.write_text(arguments->file, std::string(text_of(example_files(), arguments->name)));
      return kFine;
    };
  });
}

void add_schema_command(CLI::App& app, Action& action) {
  struct Arguments {
    std::string name = "model", file = "-";
  };
  auto* command = app.add_subcommand(
      "schema", "Write the JSON Schema (2020-12) of models or edits, for editors to check them by");
  const auto arguments = std::make_shared<Arguments>();
  only(*command->add_option("DOCUMENT", arguments->name, "Of which documents [model]"),
       names_of(schema_files()));
  add_output(*command, arguments->file);
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      check_text_file(arguments->file);
      session.write_text(arguments->file, schema_text(arguments->name));
      return kFine;
    };
  });
}

}  // namespace remeshd::cli
