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
  double least = 0;  ///< no rule asks for less than this; size controls may
  double slope = 0;  ///< growth of the edge length per distance from a source
};

/// A piece of a face or of an edge, or a part of space, that asks for edges of some length: the
/// field is no more than that length there, and grows away from it.
struct SizeSource {
  /// The part of a surface that lies in the box, or a triangle. A circle is a torus whose minor
  /// radius is 0.
  std::variant<Surface, std::array<Vec3, 3>> piece;
  Box box;              ///< round the piece
  double size = 0;      ///< length; where `varies()`, a factor on the local radius of curvature
  bool asked = false;   ///< by the model, not by a rule: `SizeLimits::least` does not apply
  bool filled = false;  ///< the part of the box behind the surface is of the piece too
  double wanted = 0;    ///< length that `size` is to bring about, where it is another

  /// The edge length that this source alone allows at p, whatever the base size. Where it is
  /// `enough` or more, the result may be any lower bound of it that is not below `enough`.
  [[nodiscard]] double at(const Vec3& p, const SizeLimits& limits, double enough = HUGE_VAL) const;
  /// Whether the length follows the radius of curvature along the piece: of a rule on a cone.
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
/// for, with a gradient of at most `SizeLimits::slope`, twice that at cones whose length varies.
///
/// Sources are closed forms in a bounding volume hierarchy, so that a query evaluates a few of them
/// however many there are. A copy shares the hierarchy. Safe from any number of threads.
class SizeField {
 public:
  /// The same edge length everywhere.
  SizeField(double base);  // NOLINT(google-explicit-constructor): a length is an even field
  /// `bounds`: round the model; queries beyond it cost more.
  SizeField(const SizeLimits& limits, std::vector<SizeSource> sources, const Box& bounds);

  /// This field made finer round some places: at each it is `share` x what it was, and grows away
  /// from there. `bounds`: round the model.
  [[nodiscard]] SizeField refined(std::span<const Vec3> places, double share,
                                  const Box& bounds) const;

  /// Edge length at a point; length.
  [[nodiscard]] double operator()(const Vec3& p) const;
  /// Whether the edge length at p is less than `length`. Cheaper than the edge length.
  [[nodiscard]] bool is_below(const Vec3& p, double length) const;
  /// Whether the model asks for any length.
  [[nodiscard]] bool has_asked() const { return asked_; }
  /// Whether the edge length at p is less than `length` and the model asks for it, not a rule.
  [[nodiscard]] bool is_asked_below(const Vec3& p, double length) const;
  /// An upper bound of the edge length at p, seldom much larger than it. Cheaper still.
  [[nodiscard]] double bound(const Vec3& p) const;
  /// The edge length that the sources allow at p without regard to the base size, or `enough` where
  /// that is less. Sources that nowhere ask for less than the base size do not count.
  [[nodiscard]] double asked_for(const Vec3& p, double enough = HUGE_VAL) const;
  /// Edge length where nothing asks for less.
  [[nodiscard]] double base() const { return limits_.base; }
  /// No edge length is less than this.
  [[nodiscard]] double least() const { return limits_.least; }
  /// Whether it is the same everywhere.
  [[nodiscard]] bool even() const { return tree_ == nullptr; }
  /// Address of the memory that its copies share, null where there is none, and its size.
  [[nodiscard]] const void* tree() const { return tree_.get(); }
  [[nodiscard]] std::size_t bytes() const;
  /// The geometric mean of the least and the base edge length: a length for the cells of grids over
  /// nodes that are spaced as the field says.
  [[nodiscard]] double grid_length() const;
  /// Bounds of the edge length in a box.
  struct Range {
    double least, greatest;
  };
  [[nodiscard]] Range in(const Box& box) const;

  /// A part, `box`, of a box, `whole`, in which the field is nearly even.
  struct EvenPart {
    Box box, whole;
    double length;  ///< the edge length in its middle
    /// Whether p, clamped to `whole`, is in this part. No point is in two parts of the same box.
    [[nodiscard]] bool holds(const Vec3& p) const;
    /// A box with all points of `bounds` that the part holds.
    [[nodiscard]] Box reach(const Box& bounds) const;
  };
  /// Parts without overlap that cover what of a box is within about an edge length of a surface.
  [[nodiscard]] std::vector<EvenPart> even_parts(const Box& box, const Surface& surface) const;

 private:
  class Tree;
  class LazyTree;
  /// `in` of a box, from what the sources ask for at its middle. Pre: not even.
  [[nodiscard]] Range around(double asked, const Box& box) const;
  void divide(const Box& box, const Box& whole, const Surface& surface,
              std::vector<EvenPart>& parts) const;

  SizeLimits limits_;
  bool asked_ = false;                    ///< whether the model asks for any length
  std::shared_ptr<const LazyTree> tree_;  ///< null where the field is even
};

}  // namespace remeshd
