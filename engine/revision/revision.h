#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/base/cow_vector.h"
#include "engine/cellular/boundary_model/support.h"
#include "engine/cellular/cellular_model.h"
#include "engine/mesh/quality.h"
#include "engine/model/feature_model.h"
#include "engine/revision/options.h"
#include "engine/revision/output_mesh.h"
#include "engine/revision/report.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// The Delaunay mesh that a revision goes on from; only the engine reads it (delaunay_state.h).
struct DelaunayState;

/// The model and nodes that a mesh's connectivity was made for, where its nodes have followed moved
/// surfaces since.
struct Anchor {
  ModelSource source;
  FeatureModel model;
  CowVector<Vec3> nodes;        ///< as delivered then
  CowVector<Support> supports;  ///< of the nodes, in the boundary of the revision's own cells
};

/// What quality drift along a chain of edits is measured against: the chain's last regular mesh.
struct QualityReference {
  double volume_length_mean = 0;
  double nodes_over_expected = 1;  ///< ratio of its nodes to those expected of its edge length
};

/// One design revision as the engine sees it: immutable once made.
struct Revision {
  /// The parent of every first mesh: no features, nodes or tets, and an infinite edge length.
  static const Revision& none();

  ModelSource source;  ///< as asked for
  /// The model of `cells`: `source` evaluated, but without motions of features from `meshed_source`
  /// that are so tiny that the mesh leaves them out (`without_tiny_motions`).
  FeatureModel model;
  /// What the mesh was made for; of an unchanged mesh its base's. It differs from `source` and
  /// `model` by spelling and by motions too small to count, which therefore cannot add up unseen.
  ModelSource meshed_source;
  FeatureModel meshed_model;
  MeshOptions options;     ///< as resolved; an edit inherits all but `nodes`, `size` and `rebuild`
  double edge_length = 0;  ///< target edge length l; an edit inherits it as its density
  double rules_weakening = 1;      ///< of the rules of its size field; an edit inherits it
  std::optional<SizeField> sizes;  ///< empty where it is still to be computed from the rest
  /// Where an edit asked for a smaller edge length than its base's, the places that it made new:
  /// that length holds there for later edits, too.
  std::vector<SizedBall> dense_places;
  CellularModel cells;
  std::shared_ptr<const DelaunayState> delaunay_state;  ///< made for `delaunay_model()`
  std::shared_ptr<const Anchor> anchor;  ///< null where the mesh is as its Delaunay mesh gave it
  OutputMesh output;
  CowVector<TetMeasure> measures;  ///< of the output tets
  CowVector<Box> boxes;            ///< round the output tets, one for each page of them
  Report report;
  QualityReference reference;

  [[nodiscard]] const FeatureModel& delaunay_model() const;
  /// The output nodes as the Delaunay mesh gave them.
  [[nodiscard]] const CowVector<Vec3>& delaunay_nodes() const;
  /// Whether an edit copies its nodes from where the anchor has them, not from where they are: held
  /// nodes may have gone far, and an even mesh is made as in older versions.
  [[nodiscard]] bool is_copied_at_anchor() const;
  /// The model on whose boundary the nodes are that an edit copies, and these output nodes.
  [[nodiscard]] const FeatureModel& copied_model() const;
  [[nodiscard]] const CowVector<Vec3>& copied_nodes() const;
  /// Of the output nodes, in the boundary of `cells`.
  [[nodiscard]] const CowVector<Support>& supports() const;
};

}  // namespace remeshd
