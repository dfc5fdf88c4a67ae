#include "engine/extract/peel.h"

#include <algorithm>
#include <limits>

#include "engine/base/parallel.h"
#include "engine/extract/common_face.h"
#include "engine/mesh/quality.h"

namespace remeshd {

namespace {

/// Stands for a neighbour in the model that is not in the patch.
constexpr std::int32_t kBeyond = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t kBlock = 1024;

template <std::size_t kCorners>
int face_of(const NodeSet& nodes, const FacesOf& faces,
            const std::array<std::int32_t, kCorners>& corners) {
  std::array<Support, kCorners> supports;
  std::ranges::transform(corners, supports.begin(),
                         [&](std::int32_t n) { return nodes.supports[n]; });
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

PeeledMesh peel(const NodeSet& nodes, const DelaunayMesh& delaunay, const BoundaryModel& boundary,
                const InsideTest& inside, const KnownClassification& known,
                const PeelOptions& options, const Run& run) {
  using Known = KnownClassification::Known;
  const auto known_of = [&](std::int32_t slot) {
    return known.tets.empty() ? Known::No : known.tets[slot];
  };
  const FacesOf faces(boundary);
  std::vector<std::uint8_t> in_model(delaunay.slots(), 0);
  in_blocks(delaunay.slots(), kBlock, run, [&](std::size_t begin, std::size_t end) {
    run.poll();
    for (auto slot = static_cast<std::int32_t>(begin); slot < static_cast<std::int32_t>(end);
         ++slot) {
      const Tet t = delaunay.corners(slot);
      if (!delaunay.in_use(slot) || std::ranges::min(t) < 0) continue;
      in_model[slot] =
          known_of(slot) == Known::Inside || contributes(nodes, boundary, faces, inside, t) ? 1 : 0;
    }
  });
  PeeledMesh mesh;
  std::vector<Tet>& tets = mesh.tets;
  tets.reserve(delaunay.size());
  mesh.slots.reserve(delaunay.size());
  std::vector<Tet> neighbours;  // by tet
  neighbours.reserve(delaunay.size());
  std::vector<std::int32_t> number(delaunay.slots(), -1);
  delaunay.for_each_tet_with_neighbours([&](std::int32_t slot, const Tet& t, const Tet& across) {
    if (in_model[slot] == 0) return;
    number[slot] = static_cast<std::int32_t>(tets.size());
    tets.push_back(t);
    mesh.slots.push_back(slot);
    neighbours.push_back(across);
  });
  for (std::size_t k = 0; k < neighbours.size(); ++k)
    for (int i = 0; i < 4; ++i) {
      std::int32_t& across = neighbours[k][i];
      const std::int32_t beyond = delaunay.exterior(mesh.slots[k], i);
      if (beyond >= 0)
        across = known.exterior[beyond] != 0 ? kBeyond : -1;
      else
        across = across < 0 ? -1 : number[across];
    }

  std::vector<std::uint8_t> gone(tets.size(), 0);
  std::vector<std::int32_t> queue;
  const auto shows_two = [&](std::size_t k) {
    return std::count(neighbours[k].begin(), neighbours[k].end(), -1) == 2 &&
           known_of(mesh.slots[k]) == Known::No;
  };
  for (std::size_t k = 0; k < tets.size(); ++k)
    if (shows_two(k)) queue.push_back(static_cast<std::int32_t>(k));
  const auto is_flat = [&](const Tet& t) {
    return face_of(nodes, faces, t) >= 0 &&
           volume_length(nodes.positions[t[0]], nodes.positions[t[1]], nodes.positions[t[2]],
                         nodes.positions[t[3]]) < options.flat;
  };
  const auto peel_off = [&](std::size_t k) {
    gone[k] = 1;
    for (const std::int32_t n : neighbours[k]) {
      if (n < 0 || n == kBeyond) continue;
      std::ranges::replace(neighbours[n], static_cast<std::int32_t>(k), -1);
      if (shows_two(n)) queue.push_back(n);
    }
  };
  std::size_t next = 0;
  const auto work_off = [&] {
    for (; next < queue.size(); ++next)
      if (const std::int32_t k = queue[next]; !gone[k] && shows_two(k) && is_flat(tets[k]))
        peel_off(k);
  };
  work_off();
  // Those that were peeled before go one by one, so that others show two facets in between.
  for (std::size_t k = 0; k < tets.size(); ++k) {
    if (gone[k] || known_of(mesh.slots[k]) != Known::Outside) continue;
    peel_off(k);
    work_off();
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < tets.size(); ++k) {
    if (gone[k]) continue;
    for (int i = 0; i < 4; ++i) {
      if (neighbours[k][i] >= 0) continue;
      const auto& f = kTetFacets[i];
      const Triangle facet{tets[k][f[0]], tets[k][f[1]], tets[k][f[2]]};
      if (face_of(nodes, faces, facet) >= 0) continue;
      const auto& p = nodes.positions;
      mesh.nonconforming.push_back((p[facet[0]] + p[facet[1]] + p[facet[2]]) / 3.0);
    }
    mesh.slots[kept] = mesh.slots[k];
    tets[kept++] = tets[k];
  }
  tets.resize(kept);
  mesh.slots.resize(kept);
  return mesh;
}

}  // namespace remeshd
