#pragma once

#include <string>

#include "client/cli/base.h"
#include "client/cli/mesh_options.h"
#include "client/cli/session.h"

namespace remeshd::cli {

/// The revision that an edit starts from.
struct MeshedBase {
  std::string revision;  ///< as it was named, else its id
  std::string design;    ///< that it was meshed in; empty where it was named, and where in none
};

/// The revision named, or that of the model, which is meshed over the stream with the options given
/// if the daemon lacks it. Throws CallError.
MeshedBase mesh_base(Session& session, client::EditStream& stream, const Base& base,
                     const MeshingOptions& meshing);

}  // namespace remeshd::cli
