#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "tests/campaign/verifier/exact_volume.h"
#include "tests/campaign/verifier/verifier.h"

namespace remeshd::campaign {
namespace {

/// A facet as its tet sees it, outward.
struct Side {
  Triangle sorted;
  Triangle outward;
  std::int32_t tet;
};

/// Whether the second is an even permutation of the first: the same side.
bool same_side(const Triangle& a, const Triangle& b) {
  for (int k = 0; k < 3; ++k)
    if (a[0] == b[k]) return a[1] == b[(k + 1) % 3];
  return false;
}

bool check_tets(const TetMesh& mesh, Findings& findings) {
  const auto nodes = static_cast<std::int32_t>(mesh.nodes.size());
  for (const Vec3& p : mesh.nodes)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      findings.add("index", "a node that is no number");
  std::vector<Tet> sorted;
  std::vector<char> used(mesh.nodes.size(), 0);
  for (const Tet& tet : mesh.tets) {
    if (std::any_of(tet.begin(), tet.end(), [&](std::int32_t n) { return n < 0 || n >= nodes; })) {
      findings.add("index", "a tet with a node that there is not");
      return false;
    }
    for (const std::int32_t n : tet) used[n] = 1;
    const Vec3& a = mesh.nodes[tet[0]];
    if (volume_sign(a, mesh.nodes[tet[1]], mesh.nodes[tet[2]], mesh.nodes[tet[3]]) <= 0)
      findings.add("volume sign", "an inverted or flat tet", a);
    sorted.push_back(tet);
    std::sort(sorted.back().begin(), sorted.back().end());
  }
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    findings.add("repeated tet", "two tets of the same nodes");
  for (std::size_t n = 0; n < used.size(); ++n)
    if (!used[n]) findings.add("orphan node", "a node in no tet", mesh.nodes[n]);
  if (mesh.tets.empty()) findings.add("index", "no tets");
  return !findings.has("index");
}

/// Every edge of the boundary in two facets, once each way; round every node one fan.
void check_surface(const TetMesh& mesh, const std::vector<Triangle>& facets, Findings& findings) {
  std::map<std::pair<std::int32_t, std::int32_t>, int> edges;
  std::vector<std::vector<std::pair<std::int32_t, std::int32_t>>> fans(mesh.nodes.size());
  for (const Triangle& f : facets)
    for (int k = 0; k < 3; ++k) {
      ++edges[{f[k], f[(k + 1) % 3]}];
      fans[f[k]].emplace_back(f[(k + 1) % 3], f[(k + 2) % 3]);
    }
  for (const auto& [edge, times] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (times != 1 || back == edges.end() || back->second != 1)
      findings.add("closed boundary", "a boundary edge that is not in two facets",
                   mesh.nodes[edge.first]);
  }
  for (std::size_t n = 0; n < fans.size(); ++n) {
    if (fans[n].empty()) continue;
    std::size_t turned = 1;
    std::int32_t at = fans[n][0].second;
    while (at != fans[n][0].first && turned <= fans[n].size()) {
      const auto next = std::find_if(fans[n].begin(), fans[n].end(),
                                     [&](const auto& spoke) { return spoke.first == at; });
      if (next == fans[n].end()) break;
      at = next->second;
      ++turned;
    }
    if (at != fans[n][0].first || turned != fans[n].size())
      findings.add("manifold node", "a boundary node with more than one fan", mesh.nodes[n]);
  }
}

}  // namespace

/// Exact positive volumes; no tet twice; no node unused; each facet in one tet or in two that lie
/// on different sides; the tets hang together by facets; the boundary is a closed 2-manifold.
std::vector<Triangle> check_connectivity(const TetMesh& mesh, Findings& findings) {
  std::vector<Triangle> facets;
  if (!check_tets(mesh, findings)) return facets;
  std::vector<Side> sides;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const auto& [i, j, k] : kTetFacets) {
      const Tet& tet = mesh.tets[t];
      Side side{{}, {tet[i], tet[j], tet[k]}, static_cast<std::int32_t>(t)};
      side.sorted = side.outward;
      std::sort(side.sorted.begin(), side.sorted.end());
      sides.push_back(side);
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.sorted < b.sorted; });
  std::vector<std::int32_t> piece(mesh.tets.size());
  std::iota(piece.begin(), piece.end(), 0);
  const auto find = [&](std::int32_t t) {
    while (piece[t] != t) t = piece[t] = piece[piece[t]];
    return t;
  };
  for (std::size_t k = 0; k < sides.size();) {
    std::size_t end = k + 1;
    while (end < sides.size() && sides[end].sorted == sides[k].sorted) ++end;
    if (end - k == 1) facets.push_back(sides[k].outward);
    if (end - k > 2) findings.add("facet", "in three tets", mesh.nodes[sides[k].sorted[0]]);
    if (end - k == 2) {
      if (same_side(sides[k].outward, sides[k + 1].outward))
        findings.add("facet", "two tets on one side", mesh.nodes[sides[k].sorted[0]]);
      piece[find(sides[k].tet)] = find(sides[k + 1].tet);
    }
    k = end;
  }
  for (std::size_t t = 1; t < piece.size(); ++t)
    if (find(static_cast<std::int32_t>(t)) != find(0)) {
      findings.add("connected", "the tets fall into pieces");
      break;
    }
  check_surface(mesh, facets, findings);
  return facets;
}

}  // namespace remeshd::campaign
