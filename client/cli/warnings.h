#pragma once

#include <string>

#include "client/cli/session.h"
#include "remesh/v1/remesh.pb.h"

namespace remeshd::cli {

using Warnings = google::protobuf::RepeatedPtrField<remesh::v1::Warning>;

/// Writes each as a line of the messages; `about`, e.g. ` (base)`, follows the word `warning`.
void show_warnings(Session& session, const Warnings& warnings, const std::string& about = "");

}  // namespace remeshd::cli
