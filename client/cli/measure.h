#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/formats/read_mesh.h"

namespace remeshd::cli {

/// What `remesh quality` tells about a mesh; names and meaning as in tests/paper/quality.py, which
/// evaluates meshes of any mesher, so that figures can be compared.
struct Measures {
  std::size_t nodes = 0;  ///< that a tet uses
  std::size_t tets = 0;
  std::size_t bnodes = 0;                     ///< on the boundary
  std::size_t bfaces = 0;                     ///< facets of one tet only
  std::size_t badfaces = 0;                   ///< facets of more than two tets
  double vl_mean = 0, vl_p1 = 0, vl_min = 0;  ///< volume-length 6 sqrt(2) V / l_rms^3
  double dih_min = 0, dih_max = 0;            ///< degrees
  double f10 = 0, f20 = 0;                    ///< share of dihedral angles below 10 and 20 degrees
  double f_tet_10 = 0, f_tet_20 = 0;          ///< share of tets that have such an angle
  std::size_t n_vl_lt_0p2 = 0;                ///< tets of volume-length below 0.2
  std::size_t neg = 0;  ///< tets that are flat, or inverted against most others
  double volume = 0;
  double edge_mean = 0;           ///< over the edges of all tets
  std::optional<double> vol_err;  ///< volume / exact - 1
};

/// Throws nothing; pre: `mesh` has a tet, and its indices are in range.
Measures measure(const client::FileMesh& mesh, std::optional<double> exact_volume);

/// As one JSON object, a line each.
std::string to_json(const Measures& measures);

}  // namespace remeshd::cli
