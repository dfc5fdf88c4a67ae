#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "engine/base/surface.h"
#include "engine/cellular/boundary_model/boundary_model.h"

namespace remeshd {

/// How a size field follows from its sources.
struct SizeLimits {
  double base = 0;   ///< edge length where nothing asks for less
  double least = 0;  ///< no source asks for less than this
  double slope = 0;  ///< how much longer edges may get on a way, per length of it
};

/// A piece of a face or of an edge, or a part of space, that asks for edges of some length: the
/// field is no more than that length there, and grows away from it.
struct SizeSource {
  /// A surface in the box; a circle is the thinnest of tori, with its radius and a tube of none. Or
  /// a triangle.
  std::variant<Surface, std::array<Vec3, 3>> piece;
  Box box;              ///< round the piece
  double size = 0;      ///< of a rule on a cone: per length of its radius of curvature
  bool asked = false;   ///< by the model, not by a rule: the least length of rules does not hold
  bool filled = false;  ///< what of the box lies behind the surface is of the piece too

  /// How long edges may be at p on behalf of this source alone, whatever the base; where that is
  /// `enough` or more, any length from there on that it is not less than.
  [[nodiscard]] double at(const Vec3& p, const SizeLimits& limits, double enough = HUGE_VAL) const;
  /// Whether the size follows the radius of curvature along the piece.
  [[nodiscard]] bool varies() const {
    const auto* surface = std::get_if<Surface>(&piece);
    return !asked && surface != nullptr && surface->kind == Surface::Kind::Cone;
  }
  /// It asks for no less than this anywhere.
  [[nodiscard]] double lowest(const SizeLimits& limits) const {
    return std::fmax(varies() ? 0 : size, asked ? 0 : limits.least);
  }
};

/// The target edge length h at each point of space: the least of a base size and what sources ask
/// for, with a gradient of at most `SizeLimits::slope`.
///
/// Sources are closed forms in a hierarchy of boxes, so that a question costs a few of them however
/// many there are. A copy shares the hierarchy. Safe from any number of threads.
class SizeField {
 public:
  /// The same edge length everywhere.
  SizeField(double base);  // NOLINT(google-explicit-constructor): a length is an even field
  /// `bounds`: round the model; questions beyond it cost more.
  SizeField(const SizeLimits& limits, std::vector<SizeSource> sources, const Box& bounds);

  /// The same, finer round some places: `share` of what it is there, growing away from them.
  /// `bounds`: round the model.
  [[nodiscard]] SizeField refined(std::span<const Vec3> places, double share,
                                  const Box& bounds) const;

  /// Edge length at a point; length.
  [[nodiscard]] double operator()(const Vec3& p) const;
  /// Whether that is less than a length. Cheaper than the edge length.
  [[nodiscard]] bool is_below(const Vec3& p, double length) const;
  /// A length that it does not exceed, and seldom is much less than. Cheaper still.
  [[nodiscard]] double bound(const Vec3& p) const;
  /// What is asked for at a point whatever the base size, where that is below `enough`, else that.
  [[nodiscard]] double asked_for(const Vec3& p, double enough = HUGE_VAL) const;
  /// Edge length where nothing asks for less.
  [[nodiscard]] double base() const { return limits_.base; }
  /// No edge length is less than this.
  [[nodiscard]] double least() const { return limits_.least; }
  /// Whether it is the same everywhere.
  [[nodiscard]] bool even() const { return tree_ == nullptr; }
  /// Memory that its copies share, where any is, and how much.
  [[nodiscard]] const void* tree() const { return tree_.get(); }
  [[nodiscard]] std::size_t bytes() const;
  /// A length between those of the field, for grids of what stands as far apart as the field says.
  [[nodiscard]] double grid_length() const;
  /// The least and the greatest that the field may be in a box.
  struct Range {
    double least, greatest;
  };
  [[nodiscard]] Range in(const Box& box) const;

  /// A part of a box in which the field is nearly even.
  struct EvenPart {
    Box box, whole;
    double length;  ///< the edge length in its middle
    /// Whether this is the part that a point, moved into the whole box, is in.
    [[nodiscard]] bool holds(const Vec3& p) const;
    /// All such points within some bounds are in this box.
    [[nodiscard]] Box reach(const Box& bounds) const;
  };
  /// Parts without overlap that cover what a surface has in a box, and about an edge length beyond.
  [[nodiscard]] std::vector<EvenPart> even_parts(const Box& box, const Surface& surface) const;

 private:
  class Tree;
  class LazyTree;
  /// The same in a box of whose middle is known what is asked for there. Pre: not even.
  [[nodiscard]] Range around(double asked, const Box& box) const;
  void divide(const Box& box, const Box& whole, const Surface& surface,
              std::vector<EvenPart>& parts) const;

  SizeLimits limits_;
  std::shared_ptr<const LazyTree> tree_;  ///< null where the field is even
};

}  // namespace remeshd
