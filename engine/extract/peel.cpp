#include "engine/extract/peel.h"

#include <algorithm>

#include "engine/extract/common_face.h"
#include "engine/mesh/quality.h"

namespace remeshd {

namespace {

int face_of(const NodeSet& nodes, const FacesOf& faces, const Tet& t) {
  const std::array<Support, 4> supports{nodes.supports[t[0]], nodes.supports[t[1]],
                                        nodes.supports[t[2]], nodes.supports[t[3]]};
  return faces.common(supports);
}

bool contributes(const NodeSet& nodes, const BoundaryModel& boundary, const FacesOf& faces,
                 const InsideTest& inside, const Tet& t) {
  for (const std::int32_t n : t)
    if (nodes.supports[n].kind == Support::Kind::Interior) return true;
  const int face = face_of(nodes, faces, t);
  if (face >= 0 && boundary.faces[face].surface.kind == Surface::Kind::Plane) return false;
  return inside(0.25 * (nodes.positions[t[0]] + nodes.positions[t[1]] + nodes.positions[t[2]] +
                        nodes.positions[t[3]]));
}

}  // namespace

std::vector<Tet> peel(const NodeSet& nodes, const kernel::Delaunay& delaunay,
                      const BoundaryModel& boundary, const InsideTest& inside,
                      const PeelOptions& options, const Run& run) {
  const FacesOf faces(boundary);
  std::vector<Tet> tets;
  tets.reserve(delaunay.size());
  std::vector<Tet> neighbours;  // by tet
  neighbours.reserve(delaunay.size());
  std::vector<std::int32_t> number(delaunay.slots(), -1);
  Polling poll(run);
  delaunay.for_each_tet_with_neighbours([&](std::int32_t slot, const Tet& t, const Tet& across) {
    poll();
    if (!contributes(nodes, boundary, faces, inside, t)) return;
    number[slot] = static_cast<std::int32_t>(tets.size());
    tets.push_back(t);
    neighbours.push_back(across);
  });
  for (Tet& across : neighbours)
    for (std::int32_t& slot : across) slot = slot < 0 ? -1 : number[slot];

  std::vector<std::uint8_t> gone(tets.size(), 0);
  std::vector<std::int32_t> queue;
  for (std::size_t k = 0; k < tets.size(); ++k)
    if (std::count(neighbours[k].begin(), neighbours[k].end(), -1) == 2)
      queue.push_back(static_cast<std::int32_t>(k));
  for (std::size_t q = 0; q < queue.size(); ++q) {
    const std::int32_t k = queue[q];
    const Tet& t = tets[k];
    if (gone[k] || std::count(neighbours[k].begin(), neighbours[k].end(), -1) != 2 ||
        face_of(nodes, faces, t) < 0 ||
        volume_length(nodes.positions[t[0]], nodes.positions[t[1]], nodes.positions[t[2]],
                      nodes.positions[t[3]]) >= options.flat)
      continue;
    gone[k] = 1;
    for (const std::int32_t n : neighbours[k]) {
      if (n < 0) continue;
      std::replace(neighbours[n].begin(), neighbours[n].end(), k, -1);
      if (std::count(neighbours[n].begin(), neighbours[n].end(), -1) == 2) queue.push_back(n);
    }
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < tets.size(); ++k)
    if (!gone[k]) tets[kept++] = tets[k];
  tets.resize(kept);
  return tets;
}

}  // namespace remeshd
