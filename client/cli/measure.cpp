#include "client/cli/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "engine/mesh/quality.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd::cli {
namespace {

constexpr std::array<std::array<std::size_t, 2>, 6> kEdges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

struct FacetCounts {
  std::size_t boundary = 0, bad = 0, boundary_nodes = 0;
};

FacetCounts count_facets(const client::FileMesh& mesh) {
  std::vector<Triangle> facets;
  facets.reserve(4 * mesh.tets.size());
  for (const Tet& tet : mesh.tets) {
    for (const auto& side : kTetFacets) {
      Triangle facet{};
      for (std::size_t k = 0; k < 3; ++k) facet[k] = tet[static_cast<std::size_t>(side[k])];
      std::ranges::sort(facet);
      facets.push_back(facet);
    }
  }
  std::ranges::sort(facets);
  FacetCounts counts;
  std::vector<std::int32_t> nodes;
  for (auto first = facets.begin(); first != facets.end();) {
    const auto next = std::find_if(first, facets.end(), [&](const auto& f) { return f != *first; });
    if (next - first == 1) {
      ++counts.boundary;
      nodes.insert(nodes.end(), first->begin(), first->end());
    }
    if (next - first > 2) ++counts.bad;
    first = next;
  }
  std::ranges::sort(nodes);
  counts.boundary_nodes =
      static_cast<std::size_t>(std::ranges::unique(nodes).begin() - nodes.begin());
  return counts;
}

std::size_t used_nodes(const client::FileMesh& mesh) {
  std::vector<std::uint8_t> used(mesh.nodes.size(), 0);
  for (const Tet& tet : mesh.tets)
    for (const std::int32_t node : tet) used[static_cast<std::size_t>(node)] = 1;
  return static_cast<std::size_t>(std::ranges::count(used, 1));
}

/// Interpolates between the two values next to rank share * (n - 1).
double percentile(std::vector<double> values, double share) {
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), values.begin() + low, values.end());
  const double a = values[static_cast<std::size_t>(low)];
  if (static_cast<std::size_t>(low) + 1 == values.size()) return a;
  const double b = *std::min_element(values.begin() + low + 1, values.end());
  return a + (b - a) * (rank - static_cast<double>(low));
}

}  // namespace

Measures measure(const client::FileMesh& mesh, std::optional<double> exact_volume) {
  const auto corners = [&](const Tet& tet) {
    std::array<Vec3, 4> p;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& [x, y, z] = mesh.nodes[static_cast<std::size_t>(tet[k])];
      p[k] = {x, y, z};
    }
    return p;
  };
  Measures out;
  out.nodes = used_nodes(mesh);
  out.tets = mesh.tets.size();
  const FacetCounts facets = count_facets(mesh);
  out.bfaces = facets.boundary;
  out.badfaces = facets.bad;
  out.bnodes = facets.boundary_nodes;

  std::size_t flat_or_negative = 0;
  std::size_t flat_or_positive = 0;
  for (const Tet& tet : mesh.tets) {
    const auto p = corners(tet);
    const double volume = tet_volume(p[0], p[1], p[2], p[3]);
    out.volume += volume;
    flat_or_negative += volume <= 0 ? 1 : 0;
    flat_or_positive += volume >= 0 ? 1 : 0;
  }
  out.neg = std::min(flat_or_negative, flat_or_positive);
  const double sign = out.volume > 0 ? 1 : -1;
  out.volume *= sign;

  const auto tets = static_cast<double>(mesh.tets.size());
  std::vector<double> quality;
  quality.reserve(mesh.tets.size());
  out.dih_min = 180;
  std::array<std::size_t, 2> angles_below{};
  std::array<std::size_t, 2> tets_below{};
  constexpr std::array<double, 2> kLimits{10, 20};
  for (const Tet& tet : mesh.tets) {
    const auto p = corners(tet);
    quality.push_back(sign * volume_length(p[0], p[1], p[2], p[3]));
    for (const auto& [a, b] : kEdges) out.edge_mean += distance(p[a], p[b]) / (6 * tets);
    auto angles = dihedral_angles(p[0], p[1], p[2], p[3]);
    for (double& angle : angles) angle *= 180 / std::numbers::pi;
    const auto [least, most] = std::ranges::minmax(angles);
    out.dih_min = std::min(out.dih_min, least);
    out.dih_max = std::max(out.dih_max, most);
    for (std::size_t k = 0; k < kLimits.size(); ++k) {
      angles_below[k] += static_cast<std::size_t>(
          std::ranges::count_if(angles, [&](double angle) { return angle < kLimits[k]; }));
      tets_below[k] += least < kLimits[k] ? 1 : 0;
    }
  }
  for (const double q : quality) out.vl_mean += q / tets;
  out.vl_p1 = percentile(quality, 0.01);
  out.vl_min = std::ranges::min(quality);
  out.n_vl_lt_0p2 =
      static_cast<std::size_t>(std::ranges::count_if(quality, [](double q) { return q < 0.2; }));
  out.f10 = static_cast<double>(angles_below[0]) / (6 * tets);
  out.f20 = static_cast<double>(angles_below[1]) / (6 * tets);
  out.f_tet_10 = static_cast<double>(tets_below[0]) / tets;
  out.f_tet_20 = static_cast<double>(tets_below[1]) / tets;
  if (exact_volume) out.vol_err = out.volume / *exact_volume - 1;
  return out;
}

std::string to_json(const Measures& m) {
  nlohmann::ordered_json json{
      {"nodes", m.nodes},       {"tets", m.tets},         {"bnodes", m.bnodes},
      {"bfaces", m.bfaces},     {"badfaces", m.badfaces}, {"vl_mean", m.vl_mean},
      {"vl_p1", m.vl_p1},       {"vl_min", m.vl_min},     {"dih_min", m.dih_min},
      {"dih_max", m.dih_max},   {"f10", m.f10},           {"f20", m.f20},
      {"f_tet_10", m.f_tet_10}, {"f_tet_20", m.f_tet_20}, {"n_vl_lt_0p2", m.n_vl_lt_0p2},
      {"neg", m.neg},           {"volume", m.volume},     {"edge_mean", m.edge_mean}};
  if (m.vol_err) json["vol_err"] = *m.vol_err;
  return json.dump(2) + "\n";
}

}  // namespace remeshd::cli
