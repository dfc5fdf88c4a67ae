#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "client/cli/session.h"
#include "remesh/v1/remesh.pb.h"

namespace CLI {
class App;
}

namespace remeshd::cli {

/// Where the mesh and the Report of a mesh or an edit go.
struct ReplyFiles {
  std::vector<std::filesystem::path> meshes;  ///< the same mesh in each
  std::string report;                         ///< `-`: the data stream; empty: nowhere

  void add_to(CLI::App& command);
  void check() const;  ///< throws what check_mesh_file and check_text_file throw
};

/// The option `-o` of commands that write a mesh.
void add_mesh_files(CLI::App& command, std::vector<std::filesystem::path>& files);

/// Tells the user what came out of a mesh or an edit: warnings and a head that stayed go to the
/// messages, mesh and Report to their files, and, unless the Report went there, a short table to
/// the data stream.
void deliver(Session& session, const remesh::v1::RevisionResult& reply, const ReplyFiles& files);

/// A way as strategies are called: `local`, `TetGen`.
std::string way_name(remesh::v1::Report::Way way);

/// `tool1-a@2`, or the id's first 12 digits where it is in no design.
std::string short_name(const remesh::v1::RevisionInfo& revision);

/// Of an id, as tables show it.
inline constexpr std::size_t kShownDigits = 12;

}  // namespace remeshd::cli
