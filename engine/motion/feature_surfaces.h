#pragma once

#include <span>
#include <vector>

#include "engine/cellular/boundary_model/support.h"
#include "engine/model/feature_model.h"
#include "engine/model/solid.h"

namespace remeshd {

/// The surfaces of features that each part of a model's boundary lies on. By them it can be
/// followed into a model of the same features with other parameter values.
class FeatureSurfaces {
 public:
  /// A face of a feature.
  struct Ref {
    int feature = -1;
    int face = -1;  ///< in `faces_of`
    friend auto operator<=>(const Ref&, const Ref&) = default;
  };

  FeatureSurfaces(const BoundaryModel& boundary, const FeatureModel& model);

  /// The surfaces of a support: of a face those of all its names; of an edge those of its faces,
  /// and at a group's rim those that cross there; of a vertex those of its edges. Ascending; none
  /// of the interior.
  [[nodiscard]] std::span<const Ref> at(const Support& support) const;

  /// Of an edge or vertex: the surfaces through it of all features that touch it, also of features
  /// without a piece of the boundary there. Where these surfaces separate, the topology changes.
  /// None for faces and the interior.
  [[nodiscard]] std::span<const Ref> touching(const Support& support) const;

 private:
  std::vector<std::vector<Ref>> faces_, edges_, vertices_;
  std::vector<std::vector<Ref>> touching_edges_, touching_vertices_;
};

/// The faces of all features of a model.
class FacesOfModel {
 public:
  explicit FacesOfModel(const FeatureModel& model);
  [[nodiscard]] const std::vector<SolidFace>& of(int feature) const { return faces_[feature]; }
  [[nodiscard]] std::size_t size() const { return faces_.size(); }
  /// Null where there is no such face.
  [[nodiscard]] const Surface* find(const FeatureSurfaces::Ref& ref) const;
  /// The surface of the face that `ref` is in a model of the same features with other parameter
  /// values. Null where the two features do not have the same number of faces of its name: a cone
  /// whose radius is 0 at an end has no face there.
  [[nodiscard]] const Surface* find(const FeatureSurfaces::Ref& ref,
                                    const FacesOfModel& other) const;

 private:
  std::vector<std::vector<SolidFace>> faces_;
};

}  // namespace remeshd
