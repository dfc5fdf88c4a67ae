#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd {

/// Signed volume, length cubed: positive for a tet oriented as in TetMesh.
double tet_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
template <class Nodes>
double tet_volume(const Nodes& nodes, const Tet& t) {
  return tet_volume(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]);
}

/// Volume-length measure 6 sqrt(2) V / l_rms^3 (Parthasarathy et al. 1994): 1 for a regular tet,
/// 0 for a flat one, negative for an inverted one.
double volume_length(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
template <class Nodes>
double volume_length(const Nodes& nodes, const Tet& t) {
  return volume_length(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]);
}

/// The six dihedral angles of a tet, rad, at edges 01 02 03 12 13 23.
std::array<double, 6> dihedral_angles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
template <class Nodes>
std::array<double, 6> dihedral_angles(const Nodes& nodes, const Tet& t) {
  return dihedral_angles(nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]);
}

struct Quality {
  double volume_length_mean = 0;
  double volume_length_p01 = 0;  ///< 1st percentile
  double volume_length_min = 0;
  double dihedral_min = 0;  ///< degrees
  double dihedral_max = 0;  ///< degrees
  double volume = 0;
  std::array<std::uint32_t, 20>
      histogram{};  ///< tets by volume-length, bins of 0.05 from 0 to 1; below 0 in the first
};

/// What one tet contributes to the quality of its mesh. Kept with the mesh, so that another one
/// measures only the tets that the two do not share. Cosines are in units of 1/32767: that finds
/// the few tets that may have the extreme angles of a mesh, which are then computed exactly.
struct TetMeasure {
  float volume_length = 0;
  std::int16_t highest_cosine = 0;  ///< of its smallest dihedral angle
  std::int16_t lowest_cosine = 0;   ///< of its largest
};

TetMeasure measure_tet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

CowVector<TetMeasure> measure_tets(const CowVector<Vec3>& nodes, const CowVector<Tet>& tets,
                                   const Run& run);

/// Tets and their measures.
struct MeasuredTets {
  const CowVector<Vec3>& nodes;
  const CowVector<Tet>& tets;
  const CowVector<TetMeasure>& measures;     ///< by tet
  std::span<const std::uint8_t> left_out{};  ///< by tet: 1 where it does not count; may be empty
};

/// Quality of a mesh of this volume from its tets' measures: the mean to seven digits, all else
/// exact. Post: zeros for an empty mesh.
Quality summarise(const MeasuredTets& tets, double volume);

/// The same for two meshes that share tets: for all tets of `first`, and for the mesh with the tets
/// of `instead` in the place of those that `first` leaves out.
struct TwoQualities {
  Quality first, second;
};
TwoQualities summarise_both(const MeasuredTets& first, double first_volume,
                            const MeasuredTets& instead, double second_volume);

/// Measures all tets and summarises. Post: zeros for an empty mesh.
Quality measure_quality(std::span<const Vec3> nodes, std::span<const Tet> tets, const Run& run);

}  // namespace remeshd
