#include <google/protobuf/util/time_util.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <optional>

#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/model_changes.h"
#include "client/cli/reply.h"
#include "client/cli/table.h"
#include "proto/json_writer.h"

namespace remeshd::cli {
namespace {

using Revisions = std::vector<remesh::v1::RevisionInfo>;

/// Models of revisions, each asked for once; none of what the daemon has no more.
class Models {
 public:
  explicit Models(Session& session) : session_(session) {}

  const std::optional<remesh::v1::FeatureModel>& of(const std::string& revision) {
    const auto [found, is_new] = models_.try_emplace(revision);
    if (!is_new) return found->second;
    try {
      found->second = session_.client().get_revision(revision, session_.call()).model();
    } catch (const client::CallError& error) {
      if (error.detail().code() != remesh::v1::Error::CODE_NOT_FOUND) throw;
    }
    return found->second;
  }

 private:
  Session& session_;
  std::map<std::string, std::optional<remesh::v1::FeatureModel>> models_;
};

/// What a revision changed of its parent.
std::string change_in_words(Models& models, const remesh::v1::RevisionInfo& revision) {
  if (revision.parent().empty()) return "first mesh";
  const auto &before = models.of(revision.parent()), &after = models.of(revision.id());
  if (!before || !after) return "-";
  return changes_in_words(*before, *after);
}

/// `models`: source of the models for the column of changes; null: there is no such column.
void list(Session& session, const Revisions& revisions, const std::string& json_file,
          Models* models) {
  if (!json_file.empty()) {
    remesh::v1::ListRevisionsResponse all;
    for (const auto& revision : revisions) *all.add_revisions() = revision;
    session.write_text(json_file, write_json(all));
  }
  if (json_file == "-") return;
  std::vector<std::vector<std::string>> rows{
      {"revision", "id", "parent", "nodes", "tets", "created", "head"}};
  if (models != nullptr) rows.front().emplace_back("change");
  for (const auto& revision : revisions) {
    rows.push_back({short_name(revision), revision.id().substr(0, kShownDigits),
                    revision.parent().empty() ? "-" : revision.parent().substr(0, kShownDigits),
                    std::to_string(revision.nodes()), std::to_string(revision.tets()),
                    google::protobuf::util::TimeUtil::ToString(revision.created()),
                    revision.head() ? "*" : ""});
    if (models != nullptr) rows.back().push_back(change_in_words(*models, revision));
  }
  write_table(session.out(), rows);
}

void add_json_option(CLI::App& command, std::string& file) {
  command.add_option("--json", file, "Write the list here; `-`: to stdout")->type_name("FILE");
}

void add_log(CLI::App& app, Action& action) {
  struct Arguments {
    std::string design, json;
    bool changes = false;
  };
  auto* command = app.add_subcommand("log", "Revisions of a design");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("DESIGN", arguments->design, "Name of the design")->required();
  command->add_flag("--changes", arguments->changes,
                    "Tell in words what each changed of its parent; the daemon reads all of them");
  add_json_option(*command, arguments->json);
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      Models models(session);
      list(session, session.client().log(arguments->design, session.call()), arguments->json,
           arguments->changes ? &models : nullptr);
      return kFine;
    };
  });
}

void add_revisions(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("revisions", "All revisions, by design");
  const auto json = std::make_shared<std::string>();
  add_json_option(*command, *json);
  command->callback([json, &action] {
    action = [json](Session& session) {
      list(session, session.client().list_revisions({}, session.call()), *json, nullptr);
      return kFine;
    };
  });
}

void add_model(CLI::App& app, Action& action) {
  struct Arguments {
    std::string revision, file;
  };
  auto* command = app.add_subcommand("model", "Write the model of a revision, as it was written");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("REV", arguments->revision, "Revision")->required();
  command->add_option("-o,--output", arguments->file, "Model document; `-`: to stdout")
      ->required()
      ->type_name("FILE");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      const auto description = session.client().get_revision(arguments->revision, session.call());
      session.write_text(arguments->file, write_document(description.model()));
      return kFine;
    };
  });
}

void add_get(CLI::App& app, Action& action) {
  struct Arguments {
    std::string revision, report_file;
    MeshOutputs meshes;
  };
  auto* command = app.add_subcommand("get", "Write the mesh of a revision");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("REV", arguments->revision, "Revision")->required();
  arguments->meshes.add_to(*command);
  command->add_option("--json", arguments->report_file, "Write its Report here; `-`: to stdout")
      ->type_name("FILE");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      arguments->meshes.check(arguments->report_file);
      check_text_file(arguments->report_file);
      session.write_mesh_of(arguments->revision, arguments->meshes);
      if (arguments->report_file.empty()) return kFine;
      const auto description = session.client().get_revision(arguments->revision, session.call());
      session.write_text(arguments->report_file, write_json(description.report()));
      return kFine;
    };
  });
}

int remove_design(Session& session, const std::string& design) {
  remesh::v1::DeleteDesignRequest request;
  request.set_design(design);
  const auto reply = session.client().delete_design(request, session.call());
  session.console().note("removed " + design + " with its " + std::to_string(reply.revisions()) +
                         " revisions and " + std::to_string(reply.meshes_deleted()) + " meshes");
  return kFine;
}

void add_rm(CLI::App& app, Action& action) {
  struct Arguments {
    std::vector<std::string> revisions;
    bool allow_head = false;
    std::string design;
  };
  auto* command = app.add_subcommand("rm", "Delete revisions, or a whole design");
  const auto arguments = std::make_shared<Arguments>();
  auto* revisions = command->add_option("REV", arguments->revisions,
                                        "`design@N` takes it out of that design, an id out of all");
  command->add_flag("--allow-head", arguments->allow_head, "Delete the head of a design, too");
  command
      ->add_option("--design", arguments->design,
                   "Delete this design with all its revisions, its head too")
      ->type_name("DESIGN")
      ->excludes(revisions);
  command->callback([arguments, &action] {
    if (arguments->revisions.empty() && arguments->design.empty())
      throw CLI::RequiredError("REV or --design");
    action = [arguments](Session& session) -> int {
      if (!arguments->design.empty()) return remove_design(session, arguments->design);
      for (const std::string& revision : arguments->revisions) {
        const auto reply =
            session.client().delete_revision(revision, arguments->allow_head, session.call());
        for (const auto& place : reply.removed())
          session.console().note("removed " + place.design() + "@" +
                                 std::to_string(place.number()) +
                                 (reply.mesh_deleted() ? " and its mesh" : ""));
      }
      return kFine;
    };
  });
}

}  // namespace

void add_revision_commands(CLI::App& app, Action& action) {
  add_model(app, action);
  add_log(app, action);
  add_revisions(app, action);
  add_get(app, action);
  add_rm(app, action);
}

}  // namespace remeshd::cli
