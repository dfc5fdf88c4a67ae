#pragma once

#include <filesystem>

#include "client/cli/session.h"
#include "remesh/v1/remesh.pb.h"

namespace remeshd::cli {

/// Tells the user what came out of a mesh or an edit: warnings and a head that stayed go to the
/// messages, the mesh to `mesh_file`, the Report to `report_file` (`-`: the data stream; empty: not
/// at all), and, unless the Report went there, a short table to the data stream.
void deliver(Session& session, const remesh::v1::RevisionReply& reply,
             const std::filesystem::path& mesh_file, const std::filesystem::path& report_file);

/// `tool1-a@2`, or the id's first 12 digits where it is in no design.
std::string short_name(const remesh::v1::RevisionInfo& revision);

}  // namespace remeshd::cli
