#pragma once

#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/model/feature_model.h"

namespace remeshd::campaign {

/// How small a model's parts are, by its evaluated boundary and membership alone, whatever it was
/// made for. Lengths in the model's unit, angles in degrees.
///
/// A length is an upper bound found at points about `spacing` apart: smaller things in between may
/// be missed, but nothing is reported that is not there.
struct Measure {
  double edge = HUGE_VAL;   ///< shortest edge; a closed one by its diameter
  double face = HUGE_VAL;   ///< narrowest face: twice the largest distance from its edges
  double wall = HUGE_VAL;   ///< shortest chord through material along a normal
  double gap = HUGE_VAL;    ///< the same through the void
  double apart = HUGE_VAL;  ///< nearest points of two edges that share no vertex
  /// Sharpest angle of material or void: between faces at an edge, between edges at a corner.
  double angle = 180;
  /// Surfaces that touch without crossing: a cusp of a face or edge, a smooth edge between faces
  /// of different features, or features that touch inside the material.
  bool tangent = false;
  bool coincident = false;  ///< features whose faces share an area
  /// Features whose faces nearly do, at most a millionth of the diagonal apart: a wall or gap too
  /// thin for `wall` and `gap`, and one that the CAD kernel may close.
  bool film = false;

  [[nodiscard]] double smallest() const;
  [[nodiscard]] bool wedge() const { return angle < 30; }
  /// The smallest face, wall, gap and edge are at least `length`; a tangent contact or a film is
  /// smaller than any length; a wedge, which has no wall at its edge, is good-natured from 30
  /// degrees on.
  [[nodiscard]] bool good_natured(double length) const;
};

/// A chord between two faces that meet is a wall only where it is longer than the wedge there
/// explains: where they meet within twice its length, the angle tells, not the chord.
Measure measure(const FeatureModel& model, const BoundaryModel& boundary, double spacing);

}  // namespace remeshd::campaign
