#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace remeshd {

/// A value as the document writes it: a number or an expression over the model's parameters.
using Scalar = std::variant<double, std::string>;

enum class Nature { Additive, Subtractive };

/// [x, y], or an arc that ends there and passes through `through`.
struct ProfileEntry {
  Scalar x, y;
  std::optional<std::array<Scalar, 2>> through;
  friend bool operator==(const ProfileEntry&, const ProfileEntry&) = default;
};

struct PlacementSource {
  std::array<Scalar, 3> origin{0.0, 0.0, 0.0};
  std::optional<std::array<Scalar, 3>> z_axis;
  std::optional<std::array<Scalar, 3>> x_axis;
  friend bool operator==(const PlacementSource&, const PlacementSource&) = default;
};

/// What stays put when a feature changes shape: its placement's origin, the centre of its local
/// bounding box, or a local point.
enum class ReferenceKind { Origin, Centre };
using ReferenceSource = std::variant<ReferenceKind, std::array<Scalar, 3>>;

struct FeatureSource {
  std::string id;
  Nature nature = Nature::Additive;
  std::string type;
  std::map<std::string, Scalar> parameters;          ///< all but the profile
  std::optional<std::vector<ProfileEntry>> profile;  ///< prism and revolution
  PlacementSource placement;
  ReferenceSource reference = ReferenceKind::Origin;
  friend bool operator==(const FeatureSource&, const FeatureSource&) = default;
};

/// A named scalar of the model, and what its value may be.
struct ParameterSource {
  std::string name;
  Scalar value;
  std::optional<double> lower{}, upper{};  ///< its value lies within them, also after an edit
  bool integer = false;                    ///< its value is whole
  std::string unit{};                      ///< a label
  std::string description{};               ///< for people; no part of a revision's id
  friend bool operator==(const ParameterSource&, const ParameterSource&) = default;
};

/// Centre x y z, and radius.
using BallSource = std::array<Scalar, 4>;
/// Least x y z, greatest x y z.
using BoxSource = std::array<Scalar, 6>;
/// Faces, by a selector, or a part of space.
using SizePlaceSource = std::variant<std::string, BallSource, BoxSource>;

/// Asks for a target edge length at a place.
struct SizeControlSource {
  std::string id;
  SizePlaceSource place;
  Scalar size;  ///< on faces it may use their feature's parameters, which hide the model's
  friend bool operator==(const SizeControlSource&, const SizeControlSource&) = default;
};

/// What may become of a group in an edit.
struct GroupPolicy {
  /// Largest change of its exact area by an edit, as a share of the parent's area.
  std::optional<double> max_area_change{};
  bool fail_emptied = false;  ///< a group that selects nothing any more fails the edit
  friend bool operator==(const GroupPolicy&, const GroupPolicy&) = default;
};

/// Faces or material under one name.
struct GroupSource {
  std::string name;
  std::string on;  ///< selector
  GroupPolicy policy{};
  friend bool operator==(const GroupSource&, const GroupSource&) = default;
};

/// A model document: what users write, edit and get back. Nothing is evaluated yet.
struct ModelSource {
  std::string name;
  std::string unit;                         ///< a label; scales nothing
  std::vector<ParameterSource> parameters;  ///< in the order written, which is kept
  std::vector<FeatureSource> features;      ///< in history order
  std::vector<SizeControlSource> sizes{};   ///< in the order written
  std::vector<GroupSource> groups{};        ///< in the order written
  friend bool operator==(const ModelSource&, const ModelSource&) = default;
};

struct SetParameter {
  std::string name;
  Scalar value;
};
/// `value` is a Scalar, or a whole profile where `name` is "profile".
struct SetFeatureParameter {
  std::string feature;
  std::string name;
  std::variant<Scalar, std::vector<ProfileEntry>> value;
};
struct SetPlacement {
  std::string feature;
  PlacementSource placement;  ///< replaces the whole placement
};
struct AddFeature {
  FeatureSource feature;
  std::string after;  ///< id; empty: at the end of history
};
struct RemoveFeature {
  std::string feature;
};
/// Adds a size control, which needs place and size, or changes the one of that id: what is left out
/// stays.
struct SetSize {
  std::string id;
  std::optional<SizePlaceSource> place{};
  std::optional<Scalar> size{};
};
struct RemoveSize {
  std::string id;
};
/// Adds a group, which needs a selector, or changes the one of that name: what is left out stays; a
/// policy replaces the whole policy.
struct SetGroup {
  std::string name;
  std::optional<std::string> on{};
  std::optional<GroupPolicy> policy{};
};
struct RemoveGroup {
  std::string name;
};
using Edit = std::variant<SetParameter, SetFeatureParameter, SetPlacement, AddFeature,
                          RemoveFeature, SetSize, RemoveSize, SetGroup, RemoveGroup>;

/// Edits of one request: run in order, all or none.
struct ModelEdit {
  std::vector<Edit> edits;
};

}  // namespace remeshd
