#pragma once

#include <string>
#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/cellular_model.h"
#include "engine/difference/classification.h"

namespace remeshd {

/// An element of a feature difference, placed as in the original model; as in the modified one
/// where only that has the feature.
struct DifferenceElement {
  DifferenceClass value = DifferenceClass::Artefact;
  double measure = 0;  ///< volume, area or length; 1 for a vertex
  Vec3 at;  ///< vertex, edge's middle, face's centroid; of a cell that of one of its faces
};

/// How one feature's geometry, interactions included, differs between two models (Sect. 4.2).
///
/// A feature owns the cells inside it and all faces, edges and vertices of those cells, whichever
/// feature they came from.
struct FeatureDifference {
  std::string id;
  std::vector<DifferenceElement> cells, faces, edges, vertices;
  ClassTotals cell_volumes, face_areas, edge_lengths, vertex_counts;
};

/// One of the two models. The pointers must outlive the call.
struct ModelView {
  const FeatureModel* features = nullptr;
  const CellularModel* cells = nullptr;
};

/// Overlays what the feature owns in both models, aligned on its reference, by a non-regular union,
/// and classifies every element by Tables 1 and 2. A feature of one model only is all old or all
/// new. The result is right for changes of at least 1e-4 of the model's diagonal.
///
/// Throws Error(KERNEL_FAILURE) where the CAD kernel fails, Error(Cancelled).
FeatureDifference feature_difference(const std::string& id, const ModelView& original,
                                     const ModelView& modified, const Run& run);

/// The difference model: the feature differences of all features of either model, those of the
/// modified model first, in history order.
std::vector<FeatureDifference> difference_model(const ModelView& original,
                                                const ModelView& modified, const Run& run);

/// The motion that aligns a feature of the modified model with the original's (Feature::alignment):
/// A_orig * A_mod^-1, exactly the identity where the feature did not move.
Transform to_original(const Feature& original, const Feature& modified);

}  // namespace remeshd
