#pragma once

#include <cstddef>
#include <string>

#include "client/cli/session.h"
#include "remesh/v1/remesh.pb.h"

namespace CLI {
class App;
}

namespace remeshd::cli {

/// Where the mesh and the Report of a mesh or an edit go.
struct ReplyFiles {
  MeshOutputs meshes;
  std::string report;  ///< `-`: the data stream; empty: nowhere

  void add_to(CLI::App& command);
  void check() const;  ///< throws UsageError, FileError
};

/// Tells the user, where a head was to move and did not, why.
void note_head_conflict(Session& session, const remesh::v1::RevisionResult& reply,
                        const std::string& why);

/// Tells the user what came out of a mesh or an edit: warnings and a head that stayed go to the
/// messages, mesh and Report to their files, and a short table to the data stream or, where a
/// mesh went there, to the messages; none where the Report went there.
void deliver(Session& session, const remesh::v1::RevisionResult& reply, const ReplyFiles& files);

/// A way as strategies are called: `local`, `TetGen`.
std::string way_name(remesh::v1::Report::Way way);

/// `tool1-a@2`, or the id's first 12 digits where it is in no design.
std::string short_name(const remesh::v1::RevisionInfo& revision);

/// Digits of an id that tables show.
inline constexpr std::size_t kShownDigits = 12;

}  // namespace remeshd::cli
