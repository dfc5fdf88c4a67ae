#include "engine/remesh/finish/stranded_nodes.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/boundary/facet_faces.h"
#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/mesh/grouping.h"
#include "engine/nodes/nearest.h"

namespace remeshd {
namespace {

struct StrandedLimits {
  double around = 1;       ///< x edge length: how far from a defect
  double beside = 1;       ///< x edge length: from some node of the face
  double on_face = 1e-7;   ///< x edge length: from the face's surface
  double off_face = 0.05;  ///< x edge length: from the face's triangles, for their chords
};
constexpr StrandedLimits kStranded;

}  // namespace

int support_stranded_nodes(NodeSet& nodes, std::span<const MeshDefect> defects,
                           const BoundaryModel& boundary, const SizeField& sizes) {
  const NearestNode grid(nodes.positions, kGridCell * sizes.grid_length());
  std::vector<std::int32_t> inside;
  for (const MeshDefect& defect : defects)
    grid.for_each_within(
        defect.place, kStranded.around * sizes(defect.place), [&](std::int32_t n, double) {
          if (nodes.supports[n].kind == Support::Kind::Interior && n >= nodes.interface_nodes)
            inside.push_back(n);
        });
  sort_unique(inside);
  const FacesOf faces_of(boundary);
  int found = 0;
  for (const std::int32_t node : inside) {
    const Vec3& p = nodes.positions[node];
    const double edge_length = sizes(p), off = kStranded.off_face * edge_length;
    std::vector<std::int32_t> faces;
    grid.for_each_within(p, kStranded.beside * edge_length, [&](std::int32_t n, double) {
      const std::span<const int> of_node = faces_of(nodes.supports[n]);
      faces.insert(faces.end(), of_node.begin(), of_node.end());
    });
    sort_unique(faces);
    for (const std::int32_t f : faces) {
      const BoundaryFace& face = boundary.faces[f];
      if (std::fabs(signed_distance(face.surface, p)) > kStranded.on_face * edge_length ||
          face_distance2(face, p) > off * off)
        continue;
      nodes.supports[node] = {Support::Kind::Face, f};
      ++found;
      break;
    }
  }
  return found;
}

}  // namespace remeshd
