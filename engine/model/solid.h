#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "engine/base/surface.h"
#include "engine/model/feature_model.h"

namespace remeshd {

/// One face of a feature: its local name (`wall`, `top`, `side3`) and its untrimmed surface in
/// world coordinates.
struct SolidFace {
  std::string name;
  Surface surface;
};

/// The closed point set of one feature in world coordinates, by closed formulas: no CAD kernel, no
/// tolerance, tens of nanoseconds per query.
class Solid {
 public:
  explicit Solid(const Feature& feature);

  /// Whether p lies in the solid. Points within rounding of the surface may go either way.
  [[nodiscard]] bool contains(const Vec3& p) const;
  /// Tight axis-aligned box in world coordinates (exact for unrotated features, else that of the
  /// rotated local box).
  [[nodiscard]] const Box& bounds() const { return bounds_; }
  [[nodiscard]] const std::vector<SolidFace>& faces() const { return faces_; }
  /// Exact volume.
  [[nodiscard]] double volume() const { return volume_; }

 private:
  /// A side of the outline of a prism or revolution, ready for crossing counts.
  struct OutlineSide {
    double x, y, dx, dy;     ///< start and chord
    double end_y;            ///< the same bits as `y` of the next side
    bool arc, bulges_right;  ///< `bulges_right`: the arc lies to the right of its chord
    double centre_x, centre_y, radius2;
  };
  /// Which closed formula applies, in the order of `Shape`. `prepare` sets its numbers a_, b_, c_:
  /// half extents, radii or their squares, a cone's slope; c_ is the height.
  enum class Form { Block, Cylinder, Cone, Sphere, Torus, Prism, Revolution, Slot };

  void prepare(const Shape& shape);
  [[nodiscard]] bool contains_local(const Vec3& q) const;
  [[nodiscard]] bool outline_contains(double x, double y) const;
  [[nodiscard]] bool within_angle(double x, double y) const;

  Box bounds_;
  Form form_ = Form::Block;
  bool rotated_ = false;
  bool full_turn_ = true, reflex_ = false;  ///< revolutions: angle 2 pi, angle above pi
  double a_ = 0, b_ = 0, c_ = 0;
  double end_cos_ = 1, end_sin_ = 0;  ///< revolutions: direction of the end plane
  Vec3 origin_, axis_x_, axis_y_, axis_z_;
  std::vector<OutlineSide> outline_;
  std::vector<SolidFace> faces_;
  double volume_ = 0;
};

/// The box of a feature in its own frame; ReferenceKind::Centre is its centre.
Box local_bounds(const Shape& shape);

/// The box of a feature in the world, as `Solid::bounds`.
Box world_bounds(const Feature& feature);

/// Boxes in the world that together cover a feature. A torus, or a revolution that stays away from
/// its axis, is a ring whose one box would be mostly hole: it gets a box per sector. Other features
/// get `world_bounds` alone.
std::vector<Box> boxes_round(const Feature& feature);

/// Exact volume of a shape.
double volume_of(const Shape& shape);

/// Faces of a feature in the order of client/docs/model.md, sides in profile order. Planes' normals
/// point out of the feature; the other surfaces' point away from their axis or centre. The wall of
/// a slot takes four entries.
std::vector<SolidFace> faces_of(const Feature& feature);

/// Which features contain a point, and so its nature: that of the last owner in history order,
/// negative where there is none. A query tests only the features near the point.
class Membership {
 public:
  explicit Membership(const FeatureModel& model);

  /// Index of the last feature that contains p, -1 if none.
  [[nodiscard]] int last_owner(const Vec3& p) const;
  /// Whether p lies in material.
  [[nodiscard]] bool inside(const Vec3& p) const;
  [[nodiscard]] bool contains(int feature, const Vec3& p) const {
    return solids_[feature].contains(p);
  }
  /// Appends the indices of all features that contain p, in history order.
  void owners(const Vec3& p, std::vector<int>& out) const;

  [[nodiscard]] const std::vector<Solid>& solids() const { return solids_; }
  [[nodiscard]] Nature nature(int feature) const { return natures_[feature]; }
  /// Box of all additive features.
  [[nodiscard]] const Box& bounds() const { return bounds_; }
  /// Box of all features.
  [[nodiscard]] const Box& bounds_of_all() const { return all_; }

 private:
  /// Features whose boxes reach into the grid cell of p, ascending; empty outside of the grid.
  [[nodiscard]] std::span<const int> candidates(const Vec3& p) const;
  [[nodiscard]] std::array<int, 3> grid_index(const Vec3& p) const;
  void build_grid();

  std::vector<Solid> solids_;
  std::vector<Nature> natures_;
  Box bounds_;
  Box all_;  ///< box of all features, which the grid divides
  int cells_per_axis_ = 1;
  Vec3 cells_per_length_;
  std::vector<int> first_;  ///< per grid cell, where its features start in `features_`
  std::vector<int> features_;
};

}  // namespace remeshd
