#pragma once

#include <memory>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model.h"
#include "engine/model/feature_model.h"

namespace remeshd {

namespace kernel {
class Brep;  ///< opaque CAD shape; kernel/brep.h
}

/// A cell of the non-manifold decomposition (Sect. 4.1).
struct Cell {
  std::vector<int> owners;  ///< features that contain it, in history order; never empty
  bool positive = false;    ///< nature of the last owner
  double volume = 0;        ///< exact
  Vec3 inside;              ///< some point well inside
};

/// Faces, edges and vertices of the cellular model; `boundary` where part of the merged boundary's
/// geometry (for edges and vertices: of its unified edges and vertices).
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

struct CellularModel {
  std::vector<Cell> cells;
  std::vector<CellFace> faces;
  std::vector<CellEdge> edges;
  std::vector<CellVertex> vertices;
  BoundaryModel boundary;
  double volume = 0;                         ///< of all positive cells, exact
  double area = 0;                           ///< of the merged boundary
  std::shared_ptr<const kernel::Brep> brep;  ///< the general fuse itself, for the difference model
};

/// General fuse of all features (Sect. 4.1).
///
/// Throws Error(FailedPrecondition): `EmptyModel` where no cell is positive, `DisconnectedModel`
/// where the positive cells do not hang together by faces, `NonManifoldModel` where one body
/// touches itself along an edge, at a vertex or, where a sphere does, at a point, `KernelFailure`
/// where the CAD kernel raised an alert or a membership sample disagrees with its result; the last
/// two name the features and the place.
CellularModel build_cells(const FeatureModel& model, const Run& run);

}  // namespace remeshd
