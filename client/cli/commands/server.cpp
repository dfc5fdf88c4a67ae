#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/table.h"
#include "proto/json_writer.h"

namespace remeshd::cli {
namespace {

std::string joined(const auto& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

void write_types(std::ostream& out, const std::vector<remesh::v1::FeatureType>& types) {
  std::vector<std::vector<std::string>> rows{{"type", "parameter", "unit", "default", "faces"}};
  for (const auto& type : types) {
    bool first = true;
    for (const auto& parameter : type.parameters()) {
      rows.push_back({first ? type.name() : "", parameter.name(), parameter.unit(),
                      parameter.required() ? "-" : parameter.default_value(),
                      first ? joined(type.faces()) : ""});
      first = false;
    }
  }
  write_table(out, rows);
}

}  // namespace

void add_types_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("types", "Types of features: parameters and names of faces");
  const auto json = std::make_shared<std::string>();
  command->add_option("--json", *json, "Write them here; `-`: to stdout")->type_name("FILE");
  command->callback([json, &action] {
    action = [json](Session& session) {
      const auto types = session.client().types(session.call());
      remesh::v1::ListFeatureTypesResponse all;
      for (const auto& type : types) *all.add_types() = type;
      if (!json->empty()) session.write_text(*json, write_json(all));
      if (*json != "-") write_types(session.out(), types);
      return kFine;
    };
  });
}

void add_info_command(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("info", "Version, limits and load of the daemon, as JSON");
  command->callback([&action] {
    action = [](Session& session) {
      session.write_text("-", write_json(session.client().info(session.call())));
      return kFine;
    };
  });
}

}  // namespace remeshd::cli
