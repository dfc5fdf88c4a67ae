#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "engine/base/vec.h"
#include "engine/model/selection/selected_faces.h"
#include "engine/model/source.h"

namespace remeshd {

/// One side of an evaluated closed profile: a segment, or an arc through a point.
struct ProfileSide {
  std::array<double, 2> from{}, to{};
  bool arc = false;
  std::array<double, 2> centre{};  ///< arcs only
  double radius = 0;               ///< arcs only
  bool counter_clockwise = true;   ///< arcs only: the way from `from` to `to`
  friend bool operator==(const ProfileSide&, const ProfileSide&) = default;
};

struct Block {
  double dx, dy, dz;
  friend bool operator==(const Block&, const Block&) = default;
};
struct Cylinder {
  double radius, height;
  friend bool operator==(const Cylinder&, const Cylinder&) = default;
};
struct Cone {
  double radius_bottom, radius_top, height;
  friend bool operator==(const Cone&, const Cone&) = default;
};
struct Sphere {
  double radius;
  friend bool operator==(const Sphere&, const Sphere&) = default;
};
struct Torus {
  double major_radius, minor_radius;
  friend bool operator==(const Torus&, const Torus&) = default;
};
struct Prism {
  std::vector<ProfileSide> profile;
  double height;
  friend bool operator==(const Prism&, const Prism&) = default;
};
struct Revolution {
  std::vector<ProfileSide> profile;
  double angle;  ///< rad, (0, 2 pi]
  friend bool operator==(const Revolution&, const Revolution&) = default;
};
struct Slot {
  double length, width, height;
  friend bool operator==(const Slot&, const Slot&) = default;
};

/// Local geometry of the types in client/docs/model.md; all lengths positive and finite, but one
/// radius of a cone may be 0.
using Shape = std::variant<Block, Cylinder, Cone, Sphere, Torus, Prism, Revolution, Slot>;

/// An evaluated feature: numbers only.
struct Feature {
  std::string id;
  Nature nature = Nature::Additive;
  Shape shape;
  Transform placement;  ///< local to world, rigid
  Vec3 reference;       ///< local point that stays put when the shape changes
  /// placement * translate(reference): the frame that the feature difference aligns on (Sect. 4.2).
  Transform alignment;
};

/// Faces of one feature, and the target edge length that a size control asks for on them.
struct SizedFaces {
  SelectedFaces on;
  double size = 0;
  friend bool operator==(const SizedFaces&, const SizedFaces&) = default;
};
struct SizedBall {
  Vec3 centre;
  double radius = 0;
  double size = 0;
  friend bool operator==(const SizedBall&, const SizedBall&) = default;
};
struct SizedBox {
  Vec3 lo, hi;
  double size = 0;
  friend bool operator==(const SizedBox&, const SizedBox&) = default;
};

/// An evaluated size control.
struct SizeControl {
  std::string id;
  /// The faces that its selector names, feature by feature in the order of history, maybe none; or
  /// a part of space.
  std::variant<std::vector<SizedFaces>, SizedBall, SizedBox> place;
  friend bool operator==(const SizeControl&, const SizeControl&) = default;
};

/// An evaluated group: a set of facets and tets that keeps its name through edits.
struct FaceGroup {
  std::string name;
  /// What its selector names, feature by feature in the order of history; maybe nothing.
  std::vector<SelectedFaces> on;
  GroupPolicy policy;
  friend bool operator==(const FaceGroup&, const FaceGroup&) = default;
};

/// An evaluated, validated model; features in history order.
struct FeatureModel {
  std::string name;
  std::vector<Feature> features;
  std::vector<SizeControl> sizes;  ///< in the order of the document
  std::vector<FaceGroup> groups;   ///< likewise

  [[nodiscard]] int index_of(const std::string& id) const;  ///< -1 if absent
};

/// Evaluates every expression and checks everything that can be checked without a CAD kernel.
///
/// Throws Error(InvalidArgument) with feature and parameter set: unknown or duplicate or malformed
/// names, missing or extra parameters, non-finite or non-positive sizes, degenerate frames,
/// self-intersecting profiles, cycles and unknown names in expressions, comma lists, assignments.
/// What is wrong with a size control has its id and field in the parameter: `sizes.holes.size`;
/// with a group likewise its name: `groups.load.on`.
FeatureModel evaluate(const ModelSource& source);

/// Applies the edits in order and returns the edited document; the argument is left as it was.
///
/// Throws Error with `edit_index` set for an unknown feature, parameter, size or group, a value of
/// the wrong kind, a bad or duplicate id of a new feature, or a new size or group that lacks a
/// part. The result is not validated otherwise.
ModelSource apply(const ModelSource& source, const ModelEdit& edit);

/// A document and what it evaluates to.
struct EvaluatedModel {
  ModelSource source;
  FeatureModel model;
};

/// Applies the edits and evaluates the result.
///
/// Throws what `apply` and `evaluate` do. `edit_index` is that of an edit with which the error
/// came: after it the document has the error, before it it has not. None where the source has it.
EvaluatedModel evaluate_edited(const ModelSource& source, const ModelEdit& edit);

/// Upper bound of the distance by which any surface of any feature moves between two models of the
/// same features in the same order; infinite between others.
double motion_bound(const FeatureModel& a, const FeatureModel& b);

/// The same for one feature; infinite where the natures, types or kinds of profile sides differ, or
/// a radius of a cone is 0 in one only.
double motion_bound(const Feature& a, const Feature& b);

/// A document in which some features have been put back to where they were.
struct TinyMotions {
  ModelSource source;
  std::vector<std::string> features;  ///< ids of those put back, in history order
};

/// Puts features back to what they are in `meshed`, with numbers for its expressions, where their
/// surfaces have moved since by more than rounding and at most `tolerance::kTinyMotion` x the
/// diagonal. With the resulting document as `meshed` the same document results again.
///
/// Throws what `evaluate` does.
TinyMotions without_tiny_motions(const ModelSource& source, const ModelSource& meshed);

/// Bounding box of all additive features in the world.
Box additive_bounds(const FeatureModel& model);

/// Whether no surface of any feature moves by more than 1e-12 x the diagonal between the two
/// models, and ids, natures and order are the same.
bool same_geometry(const FeatureModel& a, const FeatureModel& b);

/// A parameter of a feature type, as `remesh types` and ListFeatureTypes show it.
struct ParameterInfo {
  std::string name;
  std::string unit;  ///< `length`, `deg` or `profile`
  std::string description;
  bool required = true;
  std::string default_value;  ///< empty where required
};
struct FeatureTypeInfo {
  std::string name;
  std::string description;
  std::vector<ParameterInfo> parameters;
  std::vector<std::string> faces;  ///< `side1..sideN` is written as `side#`
};
const std::vector<FeatureTypeInfo>& feature_types();

}  // namespace remeshd
