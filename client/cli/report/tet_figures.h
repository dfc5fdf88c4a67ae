#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "remeshd/mesh.h"

namespace remeshd::cli {

inline constexpr std::size_t kQualityBins = 50;  ///< of volume-length, from 0 to 1
inline constexpr std::size_t kAngleBins = 90;    ///< of dihedral angles, from 0 to 180 degrees

/// Figures of one tet.
struct TetFigures {
  std::int32_t tet = -1;
  double volume_length = 0;                   ///< 6 sqrt(2) V / l_rms^3
  double least_angle = 0, largest_angle = 0;  ///< dihedral, degrees
};

/// Figures of all tets of a mesh.
struct MeshFigures {
  std::vector<float> volume_length;                     ///< by tet
  std::array<std::uint32_t, kQualityBins> qualities{};  ///< tets; below 0 in the first bin
  std::array<std::uint32_t, kAngleBins> angles{};       ///< dihedral angles, six a tet
  std::vector<TetFigures> worst;  ///< the least volume-lengths, at most ten, ascending
};

MeshFigures figures_of_tets(const client::Mesh& mesh);

}  // namespace remeshd::cli
