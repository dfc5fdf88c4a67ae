#pragma once

#include <vector>

#include "engine/base/run.h"
#include "engine/cellular/boundary_model/boundary_model.h"
#include "engine/sizing/size_field.h"
#include "engine/sizing/sizing.h"
#include "engine/sizing/thin_places.h"

namespace remeshd {

/// The length below which no rule goes in a field of this base size.
double least_size(const Sizing& sizing, double base);

/// By how much edges on the sides of a wall are shorter than it is thick, so that `layers` of them
/// come out across: more than `layers`, for between the sides the field grows.
double edges_asked_across(const Sizing& sizing);

/// A piece of a side of a wall or gap.
struct ThinSide {
  Vec3 middle;
  double area, thickness;

  /// Nodes that a mesh with edges of `length` has on it beyond those that the initial filling puts
  /// into the half of the wall next to it: that may be one layer where both sides take nodes.
  [[nodiscard]] double nodes(double length) const;
};

/// Base sizes of the fields that the rules are to make.
struct BaseSizes {
  BaseSizes(double only)  // NOLINT(google-explicit-constructor): a length is a range of one
      : greatest(only), expected(only) {}
  BaseSizes(double no_greater_than, double about) : greatest(no_greater_than), expected(about) {}
  double greatest;
  double expected;  ///< details are resolved down to the least size that belongs to this
};

/// The edge lengths that a model's boundary asks for by the rules, and those that the model's size
/// controls ask for.
///
/// Round faces and circular edges of radius r ask for edges of 2 pi r / `edges_per_circle`, divided
/// by `kReserve`. Unless `layers` is 0, walls, gaps and narrow faces ask for `layers` edges across,
/// and model edges shorter than the base size ask for edges no longer than themselves.
class SizeRules {
 public:
  /// `asked`: by controls (`size_sources`). Throws Cancelled.
  SizeRules(const BoundaryModel& boundary, const Sizing& sizing, const BaseSizes& bases,
            const Run& run, std::vector<SizeSource> asked = {});

  /// The size field with this base size.
  /// @param weakening  >= 1: the rules ask for edges so many times longer, the controls do not
  [[nodiscard]] SizeField field(double base, double weakening) const;
  /// The sides of all walls and gaps, films included.
  [[nodiscard]] std::vector<ThinSide> sides() const;
  /// The least number of links by model edge: on a circle `edges_per_circle`, less by the weakening
  /// or where the least size holds; on an arc its share of that, rounded down; on other edges 0.
  [[nodiscard]] std::vector<int> fewest_links(const BoundaryModel& boundary, double base,
                                              double weakening) const;
  struct AskedOnFace {
    int face;
    double size;
    Vec3 at;  ///< a point of what asks for it
  };
  /// Faces where the rules ask for less than the least size, which such a field does not go below,
  /// each once with the least length asked for; the shortest first.
  [[nodiscard]] std::vector<AskedOnFace> unresolved(double base, double weakening) const;
  /// What the rules ask for on faces and their edges, but for what tapers to a point; a face may
  /// come several times.
  [[nodiscard]] std::vector<AskedOnFace> asked_on_faces(double weakening) const;

 private:
  [[nodiscard]] double slope() const { return sizing_.growth - 1; }

  /// What a rule asks for on a face or along an edge of it.
  struct Detail {
    int face;
    Vec3 at;  ///< a point of the piece, or of the face
    SizeSource source;
    bool tapers = false;  ///< to a point, near which any edge is too long
  };
  /// What is round: faces, and edges that are circles.
  static std::vector<Detail> round_details_of(const BoundaryModel& boundary, double per_radius,
                                              double slope, double least);
  /// Adds the circles round the axis of a torus along which a face bends more than round its tube.
  static void add_circles_of(const BoundaryFace& face, int index, double per_radius, double least,
                             std::vector<Detail>& details);
  /// Model edges from `step` to `most` long, but for closed ones.
  static std::vector<Detail> short_edges_of(const BoundaryModel& boundary, double step,
                                            double most);
  /// Adds narrow faces up to `across_` x `most` wide, but for those so narrow beside `across_` x
  /// `least` that edges across would not make better tets.
  void add_narrow_faces(const BoundaryModel& boundary, double most, double least, const Run& run);
  /// What is asked for across a thin place.
  [[nodiscard]] double size_of(const ThinPlace& place) const { return place.thickness / across_; }

  std::vector<Detail> details_;
  std::vector<ThinPlace> thin_places_;
  std::vector<SizeSource> asked_;
  Sizing sizing_;
  double across_;  ///< `edges_asked_across`
  Box bounds_;
};

}  // namespace remeshd
