#include "client/cli/warnings.h"

namespace remeshd::cli {

void show_warnings(Session& session, const Warnings& warnings, const std::string& about) {
  for (const remesh::v1::Warning& warning : warnings)
    session.console().note("warning" + about + ": " + warning.message());
}

}  // namespace remeshd::cli
