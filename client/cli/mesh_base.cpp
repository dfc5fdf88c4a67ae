#include "client/cli/mesh_base.h"

#include "client/cli/reply.h"
#include "client/cli/warnings.h"

namespace remeshd::cli {

MeshedBase mesh_base(Session& session, client::EditStream& stream, const Base& base,
                     const MeshingOptions& meshing) {
  if (const auto* revision = std::get_if<std::string>(&base)) return {*revision, ""};
  remesh::v1::CreateRevisionRequest request;
  *request.mutable_model() = std::get<remesh::v1::FeatureModel>(base);
  meshing.fill(request, true);
  const auto reply = stream.create(std::move(request)).get();
  session.console().end_progress();
  session.poll();
  session.console().detail("base " + short_name(reply.revision()) + ", " + reply.revision().id() +
                           (reply.report().cached() ? ", from the cache" : ""));
  show_warnings(session, reply.report().warnings(), " (base)");
  return {reply.revision().id(), reply.revision().design()};
}

}  // namespace remeshd::cli
