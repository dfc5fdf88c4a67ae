#pragma once

#include <array>
#include <memory>
#include <vector>

#include "engine/base/vec.h"

namespace remeshd {

namespace kernel {
class Brep;  ///< opaque CAD shape; kernel/brep.h
}

/// A cell of the non-manifold decomposition (Sect. 4.1).
struct Cell {
  std::vector<int> owners;  ///< features that contain it, in history order; never empty
  bool positive = false;    ///< nature of the last owner
  double volume = 0;        ///< exact
  Vec3 inside;              ///< some point inside
};

/// Faces, edges and vertices of the cellular model. `owners`: of the cells that meet there;
/// `boundary`: whether it is part of the merged boundary (an edge or vertex: of its unified ones).
struct CellFace {
  std::vector<int> owners;
  std::array<int, 2> cells{-1, -1};  ///< on its two sides; -1 outside of all features
  bool boundary = false;
  double area = 0;
};
struct CellEdge {
  std::vector<int> owners;
  bool boundary = false;
  double length = 0;
  int element = -1;  ///< its index in `brep`; cells and faces have the same index here and there
};
struct CellVertex {
  std::vector<int> owners;
  bool boundary = false;
  Vec3 position;
  int element = -1;  ///< its index in `brep`
};

/// All cells of a model with their faces, edges and vertices, those inside the material included: a
/// general fuse of all features. The difference model is made of these.
struct CellComplex {
  std::vector<Cell> cells;
  std::vector<CellFace> faces;
  std::vector<CellEdge> edges;
  std::vector<CellVertex> vertices;
  std::shared_ptr<const kernel::Brep> brep;  ///< the general fuse itself
};

}  // namespace remeshd
