#include "engine/patch/copied_mesh.h"

#include "engine/revision/delaunay_state.h"

namespace remeshd {

CopiedMesh copied_mesh(const Revision& revision) {
  const DelaunayState& state = *revision.delaunay_state;
  CopiedMesh mesh{state,
                  revision.supports(),
                  {revision.copied_nodes(), revision.output.mesh.tets},
                  state.positions(),
                  {}};
  if (!revision.anchor || revision.is_copied_at_anchor()) return mesh;
  const CowVector<Vec3>&then = revision.anchor->nodes, &now = mesh.output.nodes;
  for (std::size_t n = 0; n < now.size(); ++n) {
    if (now[n] == then[n]) continue;
    const Vec3& p = state.positions()[n];
    // Clean-up slides nodes along surfaces, which may be curved.
    const Vec3 place =
        p == then[n] ? now[n]
                     : project(revision.cells.boundary, mesh.supports[n], p + now[n] - then[n]);
    mesh.positions.set(n, place);
    mesh.followed.push_back(static_cast<std::int32_t>(n));
  }
  return mesh;
}

}  // namespace remeshd
