#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/region.h"
#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"
#include "engine/model/solid.h"

namespace remeshd {

/// A feature that both models have, and so may supply nodes (Sect. 6.3).
struct SourceFeature {
  int original = -1;            ///< index in the original model
  int modified = -1;            ///< index in the modified model
  std::int32_t transform = -1;  ///< index into CopyPlan::transforms
  Transform to_original;        ///< A_orig * A_mod^-1; the identity where copied in place
  /// Whether the original feature, moved by the transformation, is the modified one; false where it
  /// moved and is copied in place.
  bool same_shape = false;
  double volume = 0;  ///< of the copycells it covers, estimated on a lattice
};

struct CopyLengths {
  double edge_length = 0;  ///< target; copycells' volumes are measured on no finer lattice
  /// A length. A feature that moves by less, and by less than a tenth of its least extent, is
  /// copied where it is, not with its motion as in the paper: its faces move by less than its nodes
  /// are apart, and the mesh of what crosses it stays.
  double in_place = 0;
};

/// Where the material at a point of the modified model comes from, by point membership in the
/// features of both models: exact however small the change is.
///
/// A point of the modified model lies in a copycell if for one of its owners the place where that
/// owner had it, A_orig A_mod^-1 p, lies in the original owner and in material
/// (persistent-identical positive, Table 2); it lies in a newcell otherwise. Several owners may
/// offer it: the one with the largest volume of copycells wins (Sects. 6.2-6.4).
class CopyPlan {
 public:
  static constexpr std::int32_t kOutside = -2;  ///< not in the modified model
  static constexpr std::int32_t kNew = -1;      ///< in a newcell

  /// Of an original without features everything is new.
  CopyPlan(const FeatureModel& original, const FeatureModel& modified, const CopyLengths& lengths,
           const Run& run);

  /// Whether material is made anew at a place to which a transformation would carry it.
  using AnewTest = std::function<bool(const Vec3& p, std::int32_t transform)>;
  /// This plan, but with all material in a region made anew; or with that for which `is_anew`
  /// holds, which is asked only in `boxes` and in changed() of this plan.
  [[nodiscard]] CopyPlan with_new_in(const Region& region) const;
  [[nodiscard]] CopyPlan with_new_where(AnewTest is_anew, std::span<const Box> boxes) const;

  /// kOutside, kNew or the index of the transformation that carries the material at p.
  [[nodiscard]] std::int32_t operator()(const Vec3& p) const;

  /// Whether the face through p with unit normal n is active (Sect. 7): its two sides come from
  /// different places, or it is boundary in one model only, unless all its material is new.
  [[nodiscard]] bool active_face(const Vec3& p, const Vec3& n) const;

  /// Distinct transformations from original to modified coordinates.
  [[nodiscard]] const std::vector<Transform>& transforms() const { return transforms_; }
  [[nodiscard]] const std::vector<Transform>& inverses() const { return inverses_; }
  /// The index of the transformation that moves nothing; -1 where there is none.
  [[nodiscard]] std::int32_t identity() const { return identity_; }
  /// The features that both models have, in copying order: largest volume of copycells first, equal
  /// volumes in history order.
  [[nodiscard]] const std::vector<SourceFeature>& sources() const { return sources_; }
  /// Outside of these boxes the models are the same and everything is copied in place.
  [[nodiscard]] const std::vector<Box>& changed() const { return changed_; }
  [[nodiscard]] bool in_changed(const Vec3& p, double margin = 0) const;

  /// Whether the box round a tet's nodes meets one of the changed boxes; super vertices, whose
  /// numbers are negative, do not count.
  template <class Nodes>
  [[nodiscard]] bool meets_changed(const Tet& tet, const Nodes& nodes) const {
    Box box;
    for (const std::int32_t n : tet)
      if (n >= 0) box.add(nodes[n]);
    return meets_changed(box);
  }
  [[nodiscard]] bool meets_changed(const Box& box) const;

  /// Boxes that hold all that lies both within `bounds` and in a changed box. Two are merged where
  /// the box round both has no more volume than the two have, as those of a feature before and
  /// after a small change.
  [[nodiscard]] std::vector<Box> changed_within(const Box& bounds) const;

  [[nodiscard]] const Membership& modified() const { return modified_; }
  [[nodiscard]] const Membership& original() const { return original_; }
  /// Whether the original model has features, which may supply nodes.
  [[nodiscard]] bool copies() const { return !original_.solids().empty(); }
  [[nodiscard]] double probe() const { return probe_; }

 private:
  [[nodiscard]] std::int32_t copied_by(const Vec3& p) const;
  void match(const FeatureModel& original, const FeatureModel& modified, double in_place);
  void measure(double edge_length, const Run& run);
  [[nodiscard]] bool moves_less(int original, const Transform& motion, double in_place) const;
  std::int32_t find_transform(const Feature& original, const Feature& modified);

  Membership modified_;
  Membership original_;
  std::vector<Transform> transforms_, inverses_;
  std::vector<SourceFeature> sources_;
  std::vector<Box> changed_;
  std::vector<AnewTest> anew_;  ///< what is made anew beside newcells
  std::int32_t identity_ = -1;
  double probe_ = 0;  ///< how far from a face its two sides are looked at
};

/// The plan for people: the features that supply nodes in copying order, a line each, with the
/// volume of their copycells, the index of their transformation unless it is the identity, and
/// whether their shape changed; then the boxes of what changed.
/// `original`: the model that it copies from.
std::string to_text(const CopyPlan& plan, const FeatureModel& original);

}  // namespace remeshd
