#pragma once

#include <string>
#include <vector>

#include "engine/difference/classification.h"
#include "engine/model/solid.h"

namespace remeshd {

/// A feature of either model and how its frames relate.
struct FeaturePair {
  std::string id;
  int original = -1;      ///< index, -1 if not there
  int modified = -1;      ///< index, -1 if not there
  Transform to_original;  ///< A_orig * A_mod^-1; the identity where only one model has it
  /// Whether both models have it with the same shape, nature and place in history.
  bool same = false;
};

/// Tables 1 and 2 by point membership: the same classes as the overlay's, but right however small
/// the change is, since no surfaces that nearly coincide are intersected.
///
/// Points are given in modified coordinates; for a feature of the original model only, in original
/// ones.
class PointClasses {
 public:
  PointClasses(const FeatureModel& original, const FeatureModel& modified);

  /// Features of the modified model in history order, then those of the original only.
  [[nodiscard]] const std::vector<FeaturePair>& features() const { return features_; }
  [[nodiscard]] const Membership& original() const { return original_; }
  [[nodiscard]] const Membership& modified() const { return modified_; }

  /// Class of the cell round p in the difference of a feature (index in `features()`); Artefact
  /// where the feature has p in neither model.
  [[nodiscard]] DifferenceClass cell(int feature, const Vec3& p) const;

  /// Class of the face through p with unit normal n, looked at from both sides at distance
  /// `probe`; Artefact where the feature has no face there in either model.
  [[nodiscard]] DifferenceClass face(int feature, const Vec3& p, const Vec3& n, double probe) const;

  /// Whether p lies in material of the modified model that some owner can bring along: the owner
  /// had material at that place in its own frame before (Sect. 6.2).
  [[nodiscard]] bool in_copycell(const Vec3& p) const;
  /// Whether p lies in material of the modified model that no owner can bring along.
  [[nodiscard]] bool in_newcell(const Vec3& p) const;

  /// Boxes that do not overlap and hold everything that is not persistent-identical to a feature
  /// (index in `features()`), in the coordinates its points are given in.
  [[nodiscard]] std::vector<Box> changed(int feature) const;
  /// Boxes that do not overlap and hold all newcells, in modified coordinates.
  [[nodiscard]] std::vector<Box> changed() const;

 private:
  [[nodiscard]] std::vector<Box> changed_seen_from(const Transform& to_original,
                                                   const Box& within) const;

  Membership original_, modified_;
  std::vector<FeaturePair> features_;
};

}  // namespace remeshd
