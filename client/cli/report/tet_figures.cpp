#include "client/cli/report/tet_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/mesh/quality.h"

namespace remeshd::cli {
namespace {

constexpr std::size_t kWorst = 10;

std::array<Vec3, 4> corners_of(const client::Mesh& mesh, std::size_t tet) {
  std::array<Vec3, 4> p;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& [x, y, z] = mesh.nodes[static_cast<std::size_t>(mesh.tets[tet][k])];
    p[k] = {x, y, z};
  }
  return p;
}

std::array<double, 6> angles_in_degrees(const std::array<Vec3, 4>& p) {
  auto angles = dihedral_angles(p[0], p[1], p[2], p[3]);
  for (double& angle : angles) angle *= 180 / std::numbers::pi;
  return angles;
}

template <std::size_t Bins>
void count_in(std::array<std::uint32_t, Bins>& bins, double share) {
  const double bin = std::clamp(share * Bins, 0.0, static_cast<double>(Bins - 1));
  ++bins[std::isnan(bin) ? 0 : static_cast<std::size_t>(bin)];
}

TetFigures figures_of(const client::Mesh& mesh, std::size_t tet) {
  const auto p = corners_of(mesh, tet);
  const auto angles = angles_in_degrees(p);
  const auto [least, largest] = std::ranges::minmax(angles);
  return {.tet = static_cast<std::int32_t>(tet),
          .volume_length = volume_length(p[0], p[1], p[2], p[3]),
          .least_angle = least,
          .largest_angle = largest};
}

}  // namespace

MeshFigures figures_of_tets(const client::Mesh& mesh) {
  MeshFigures out;
  out.volume_length.reserve(mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto p = corners_of(mesh, t);
    const double quality = volume_length(p[0], p[1], p[2], p[3]);
    out.volume_length.push_back(static_cast<float>(quality));
    count_in(out.qualities, quality);
    for (const double angle : angles_in_degrees(p)) count_in(out.angles, angle / 180);
  }
  std::vector<std::size_t> order(mesh.tets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto worst = order.begin() + static_cast<std::ptrdiff_t>(std::min(kWorst, order.size()));
  std::ranges::partial_sort(order, worst, [&](std::size_t a, std::size_t b) {
    return std::pair(out.volume_length[a], a) < std::pair(out.volume_length[b], b);
  });
  for (auto tet = order.begin(); tet != worst; ++tet) out.worst.push_back(figures_of(mesh, *tet));
  return out;
}

}  // namespace remeshd::cli
