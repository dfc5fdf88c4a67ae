#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "client/cli/report/correspondence.h"
#include "client/cli/report/tet_figures.h"
#include "remeshd/mesh.h"

namespace remeshd::cli {

/// Rows of numbers as the page has them: little-endian, without gaps.
struct PageArray {
  std::string name;
  std::string type;  ///< `f32`, `i32` or `u8`
  std::size_t components = 1;
  std::size_t count = 0;  ///< rows
  std::string bytes;
};

/// What the arrays of one mesh are made from.
struct PageMesh {
  const client::Mesh& mesh;
  const MeshFigures& figures;
  const std::vector<TetState>& states;  ///< by tet
  std::array<double, 3> centre{};       ///< of the scene
  bool surfaces_only = false;
};

/// `nodes` (f32 x 3, from the scene's centre), `sizes` (f32, of nodes, where the mesh has them);
/// `facets` (i32 x 3), `facet_group` (i32), `facet_tet` (i32), `facet_cell` (i32), `facet_state`
/// (u8), `facet_quality` (u8), the last three of the facet's tet; `tets` (i32 x 4), `tet_cell`
/// (i32), `tet_state` (u8) and `tet_quality` (u8).
///
/// A quality is the volume-length, 0 to 1 as 0 to 255. Of surfaces only there are no tets, no
/// `facet_tet`, and no nodes but those of facets, in their order in the mesh.
std::vector<PageArray> page_arrays(const PageMesh& page);

/// Compressed in the zlib format, as base64.
std::string packed(const std::string& bytes);

}  // namespace remeshd::cli
