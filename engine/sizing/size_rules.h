#pragma once

#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/sizing/size_field.h"
#include "engine/sizing/sizing.h"
#include "engine/sizing/thin_places.h"

namespace remeshd {

/// What no rule goes below in a field of this base size.
double least_size(const Sizing& sizing, double base);

/// A piece of a side of a wall or gap.
struct ThinSide {
  Vec3 middle;
  double area, thickness;

  /// Nodes that it needs beyond those of a start, where edges are `length` long: both sides of a
  /// wall take nodes where a start has a layer of them between.
  [[nodiscard]] double nodes(double length) const;
};

/// Base sizes of the fields to be made.
struct BaseSizes {
  BaseSizes(double only)  // NOLINT(google-explicit-constructor): a length is a range of one
      : greatest(only), expected(only) {}
  BaseSizes(double no_greater_than, double about) : greatest(no_greater_than), expected(about) {}
  double greatest;
  double expected;  ///< walls and gaps are told apart down to the least size of a field of this one
};

/// What a model's boundary asks for by the rules: round faces and circular edges of radius r for
/// edges of 2 pi r / `edges_per_circle`, walls, gaps and narrow faces for `layers` of them across,
/// model edges that are shorter than the base size for edges no longer than they are, where there
/// are layers.
/// Beside them what the model's size controls ask for.
class SizeRules {
 public:
  /// `asked`: by controls (`size_sources`). Throws Cancelled.
  SizeRules(const BoundaryModel& boundary, const Sizing& sizing, const BaseSizes& bases,
            const Run& run, std::vector<SizeSource> asked = {});

  /// The size field with that base size.
  /// @param weakening  >= 1: the rules ask for edges so many times longer, the controls do not
  [[nodiscard]] SizeField field(double base, double weakening) const;
  /// The sides of all walls and gaps.
  [[nodiscard]] std::vector<ThinSide> sides() const;
  /// By model edge: mesh edges along a circle, or as many of an arc as there are whole ones; else
  /// 0.
  [[nodiscard]] std::vector<int> fewest_links(const BoundaryModel& boundary, double base,
                                              double weakening) const;
  /// Faces where the least size of such a field is more than the rules ask for; ascending.
  [[nodiscard]] std::vector<int> unresolved(double base, double weakening) const;

  struct AskedOnFace {
    int face;
    double size;
  };
  /// What the rules ask for on faces and their edges; a face may come several times.
  [[nodiscard]] std::vector<AskedOnFace> asked_on_faces(double weakening) const;

 private:
  [[nodiscard]] double slope() const { return sizing_.growth - 1; }

  /// What a rule asks for on a face or along an edge of it.
  struct Detail {
    int face;
    SizeSource source;
    bool tapers = false;  ///< to a point, near which any edge is too long
  };
  /// What is round: faces, and edges that are circles.
  static std::vector<Detail> round_details_of(const BoundaryModel& boundary, double per_radius,
                                              double slope, double least);
  /// Of a face of a torus.
  static void add_circles_of(const BoundaryFace& face, int index, double per_radius, double least,
                             std::vector<Detail>& details);
  /// Edges from `step` to `most` long.
  static std::vector<Detail> short_edges_of(const BoundaryModel& boundary, double step,
                                            double most);
  /// Faces from a low step's width to `layers` times `most` wide.
  void add_narrow_faces(const BoundaryModel& boundary, double most, double least, const Run& run);
  /// What is asked for across a thin place.
  [[nodiscard]] double size_of(const ThinPlace& place) const {
    return place.thickness / sizing_.layers;
  }

  std::vector<Detail> details_;
  std::vector<ThinPlace> thin_places_;
  std::vector<SizeSource> asked_;
  Sizing sizing_;
  Box bounds_;
};

}  // namespace remeshd
