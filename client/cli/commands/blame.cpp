#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>

#include "client/cli/commands/command.h"
#include "client/cli/exit_code.h"
#include "client/cli/model_changes.h"
#include "client/cli/reply.h"
#include "client/cli/table.h"
#include "engine/base/text/nearest_name.h"

namespace remeshd::cli {
namespace {

namespace v1 = remesh::v1;

/// The permanent id that the whole text is; nothing where it is no number.
std::optional<std::uint64_t> node_id_in(const std::string& text) {
  std::uint64_t id = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (problem != std::errc() || end != text.data() + text.size()) return {};
  return id;
}

/// Names of the faces on a mesh's boundary.
std::vector<std::string> face_names(const client::Mesh& mesh) {
  std::vector<std::string> names;
  for (const std::vector<std::string>& group : mesh.facet_groups)
    names.insert(names.end(), group.begin(), group.end());
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

/// A face by its name, or a node by its permanent id.
struct Wanted {
  std::string text;
  std::optional<std::uint64_t> node;

  [[nodiscard]] client::MeshWanted arrays() const {
    if (node) return {.arrays = {v1::MESH_ARRAY_NODE_IDS}};
    return {.arrays = {v1::MESH_ARRAY_FACET_GROUPS}};
  }
  [[nodiscard]] bool is_in(const client::Mesh& mesh) const {
    if (!node) return std::ranges::binary_search(face_names(mesh), text);
    return std::ranges::find(mesh.node_ids, *node) != mesh.node_ids.end();
  }
};

client::CallError not_there(const Wanted& wanted, const std::string& revision,
                            const client::Mesh& mesh) {
  v1::Error error;
  error.set_code(v1::Error::CODE_NOT_FOUND);
  error.set_reason(v1::Error::UNKNOWN_NAME);
  error.set_stage("request");
  const std::string where = "the mesh of " + revision + " has no ";
  if (wanted.node)
    error.set_message(where + "node of the permanent id " + wanted.text);
  else
    error.set_message(where + "face '" + wanted.text + "'" +
                      suggestion(wanted.text, face_names(mesh)));
  error.set_hint("wanted is the name of a face, feature.face, or the permanent id of a node");
  return client::CallError(std::move(error));
}

/// Nothing where the daemon does not have the revision any more: it was deleted, which ends the
/// walk.
std::optional<v1::GetRevisionResponse> find_revision(Session& session, const std::string& id) {
  try {
    return session.client().get_revision(id, session.call());
  } catch (const client::CallError& error) {
    if (error.detail().code() != v1::Error::CODE_NOT_FOUND) throw;
    return {};
  }
}

int blame(Session& session, const std::string& name, const Wanted& wanted) {
  auto made = session.client().get_revision(name, session.call());
  const auto mesh_of = [&](const std::string& id) {
    return session.client().get_mesh(id, session.call(), {}, wanted.arrays());
  };
  const client::Mesh newest = mesh_of(made.revision().id());
  if (!wanted.is_in(newest)) throw not_there(wanted, name, newest);
  std::string change = "first mesh";
  while (!made.revision().parent().empty()) {
    session.poll();
    auto parent = find_revision(session, made.revision().parent());
    if (!parent) {
      change = "this or an older one: its parent is not there any more";
      break;
    }
    if (!wanted.is_in(mesh_of(parent->revision().id()))) {
      change = changes_in_words(parent->model(), made.model());
      break;
    }
    made = *std::move(parent);
  }
  write_table(session.out(), {{wanted.node ? "node" : "face", wanted.text},
                              {"made by", short_name(made.revision())},
                              {"revision", made.revision().id()},
                              {"change", change}});
  return kFine;
}

}  // namespace

void add_blame_command(CLI::App& app, Action& action) {
  struct Arguments {
    std::string revision, what;
  };
  auto* command = app.add_subcommand(
      "blame", "Tell which revision, and which change, made a face or a node of a mesh");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("REV", arguments->revision, "Revision")->required();
  command
      ->add_option("FACE|NODE", arguments->what,
                   "Name of a face (rib.top), or permanent id of a corner node (`node_id` in .vtu)")
      ->required();
  command->footer(
      "Walks from REV to its parents as long as their meshes have it: what vanished and came back "
      "is blamed on the revision that brought it back.");
  command->callback([arguments, &action] {
    action = [arguments](Session& session) {
      return blame(session, arguments->revision,
                   {.text = arguments->what, .node = node_id_in(arguments->what)});
    };
  });
}

}  // namespace remeshd::cli
