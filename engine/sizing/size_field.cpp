#include "engine/sizing/size_field.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/sizing/box_tree.h"

namespace remeshd {

namespace {

struct TreeLimits {
  std::size_t leaf = 4;  ///< a tree node with at most so many sources has no children
  double cells = 48;     ///< of the grid, along the diagonal of the bounds
};
constexpr TreeLimits kTreeLimits;

struct Refinement {
  double slope = 0.3;  ///< of a refined field that was even
};
constexpr Refinement kRefinement;

struct PartLimits {
  double even = 1.2;   ///< the greatest edge length of a part over the least
  double least = 1.5;  ///< x edge length: a part that small is not divided
};
constexpr PartLimits kParts;

/// Cubes that fill a box.
class BoxGrid {
 public:
  explicit BoxGrid(const Box& box) : box_(box), side_(box.diagonal() / kTreeLimits.cells) {
    const Vec3 sides = box.hi - box.lo;
    const auto count = [&](double side) {
      return static_cast<std::size_t>(std::max(std::ceil(side / side_), 1.0));
    };
    counts_ = {count(sides.x), count(sides.y), count(sides.z)};
  }
  [[nodiscard]] std::size_t cells() const { return counts_[0] * counts_[1] * counts_[2]; }
  [[nodiscard]] Vec3 middle(std::size_t cell) const {
    const auto along = [&](std::size_t k) { return (static_cast<double>(k) + 0.5) * side_; };
    return box_.lo + Vec3{along(cell % counts_[0]), along(cell / counts_[0] % counts_[1]),
                          along(cell / (counts_[0] * counts_[1]))};
  }
  /// From the middle of a cell to its corners.
  [[nodiscard]] double radius() const { return 0.5 * std::sqrt(3.0) * side_; }
  [[nodiscard]] std::optional<std::size_t> cell_of(const Vec3& p) const {
    if (!box_.contains(p)) return std::nullopt;
    const auto along = [&](double offset, std::size_t count) {
      return std::min(static_cast<std::size_t>(offset / side_), count - 1);
    };
    const Vec3 d = p - box_.lo;
    return along(d.x, counts_[0]) +
           counts_[0] * (along(d.y, counts_[1]) + counts_[1] * along(d.z, counts_[2]));
  }

 private:
  Box box_;
  double side_;
  std::array<std::size_t, 3> counts_;
};

}  // namespace

double SizeSource::at(const Vec3& p, const SizeLimits& limits, double enough) const {
  const double to_box = std::sqrt(distance2(box, p));
  const double bound = lowest(limits) + limits.slope * to_box;
  if (bound >= enough) return bound;
  if (const auto* triangle = std::get_if<std::array<Vec3, 3>>(&piece))
    return lowest(limits) + limits.slope * std::sqrt(triangle_distance2(p, *triangle));
  const auto& surface = std::get<Surface>(piece);
  const double here = varies() ? size * radius_of_curvature(surface, project(surface, p)) : size;
  const double beside = signed_distance(surface, p);
  return std::max(here, lowest(limits)) +
         limits.slope * std::max(filled ? beside : std::fabs(beside), to_box);
}

/// A bounding volume hierarchy of the sources, searched for the one that asks for the least, and a
/// grid that tells for each of its cells which source to try first.
class SizeField::Tree {
 public:
  Tree(const SizeLimits& limits, std::vector<SizeSource> sources, const Box& bounds)
      : limits_(limits), sources_(std::move(sources)), grid_(bounds) {
    const bool cones = std::ranges::any_of(sources_, &SizeSource::varies);
    steepest_ = (cones ? 2 : 1) * limits.slope;
    nodes_.reserve(most_nodes(sources_.size()));
    divide(sources_);
    begin_at_.assign(grid_.cells(), 0);
    std::int32_t last = 0;
    for (std::size_t cell = 0; cell < begin_at_.size(); ++cell) {
      const Vec3 middle = grid_.middle(cell);
      Least least{sources_[last].at(middle, limits_), last};
      search(middle, least);
      last = least.source;
      const bool matters = least.size - steepest_ * grid_.radius() < limits_.base;
      begin_at_[cell] = matters ? last : -1;
    }
  }

  /// Bound of the field's gradient: twice the slope where there are cones, along which the length
  /// varies while it also grows away from them.
  [[nodiscard]] double steepest() const { return steepest_; }
  [[nodiscard]] const std::vector<SizeSource>& sources() const { return sources_; }
  /// No rule goes below this.
  [[nodiscard]] double least() const { return limits_.least; }
  /// Memory of a tree of so many sources.
  [[nodiscard]] static std::size_t bytes(std::size_t sources, const Box& bounds) {
    return sources * sizeof(SizeSource) + most_nodes(sources) * sizeof(Node) +
           BoxGrid(bounds).cells() * sizeof(std::int32_t);
  }
  /// The least that sources ask for at p, or `enough` where that is less.
  [[nodiscard]] double operator()(const Vec3& p, double enough = HUGE_VAL) const {
    const Beginning beginning = begin(p, enough);
    if (beginning.none_matters) return enough;
    Least least{beginning.size, -1};
    search(p, least);
    return least.size;
  }
  /// Whether a source asks for less than `length` at p.
  [[nodiscard]] bool any_below(const Vec3& p, double length) const {
    const Beginning beginning = begin(p, length);
    if (beginning.none_matters || beginning.size < length) return !beginning.none_matters;
    Least least{length, -1, length};
    search(p, least);
    return least.source >= 0;
  }
  /// Whether of all sources one that the model asks for asks for the least at p, and for less than
  /// `length`.
  [[nodiscard]] bool least_is_asked(const Vec3& p, double length) const {
    if (begin(p, length).none_matters) return false;
    Least least{length, -1};
    search(p, least);
    return least.source >= 0 && sources_[least.source].asked;
  }
  /// What one source near p asks for, or `enough` where that is less: no less than the least.
  [[nodiscard]] double of_one(const Vec3& p, double enough) const { return begin(p, enough).size; }

 private:
  struct Node {
    Box box;
    double size;          ///< lower bound of what its sources ask for
    std::int32_t begin;   ///< of its sources
    std::int32_t count;   ///< of them; 0: it has two children
    std::int32_t second;  ///< the second child; the first is the next node
  };
  /// Leaves have at least two sources, but for that of one alone.
  static std::size_t most_nodes(std::size_t sources) { return sources + 1; }
  struct Least {
    double size;
    std::int32_t source;
    double sought = 0;  ///< the search ends once `size` is less than this
  };
  struct Beginning {
    double size;        ///< what the source to try first asks for; `enough` if that is less
    bool none_matters;  ///< no source asks for less than `enough`
  };
  [[nodiscard]] Beginning begin(const Vec3& p, double enough) const {
    const std::optional<std::size_t> cell = grid_.cell_of(p);
    if (!cell) return {enough, false};
    const std::int32_t first = begin_at_[*cell];
    if (first < 0) return {enough, enough <= limits_.base};
    return {std::min(enough, sources_[first].at(p, limits_, enough)), false};
  }

  /// Whether a source of a node may ask for less than `least` at a point. `distance2`: square of
  /// the point's distance from the node's box.
  [[nodiscard]] bool may_have_less(const Node& node, double distance2, const Least& least) const {
    const double reach = least.size - node.size;
    return reach > 0 && distance2 * limits_.slope * limits_.slope < reach * reach;
  }

  /// Adds the node of these sources, which it reorders, and its descendants.
  void divide(std::span<SizeSource> sources) {
    const std::size_t at = nodes_.size();
    Node node{{}, HUGE_VAL, static_cast<std::int32_t>(sources.data() - sources_.data()), 0, 0};
    for (const SizeSource& source : sources) {
      node.box.add(source.box);
      node.size = std::min(node.size, source.lowest(limits_));
    }
    nodes_.push_back(node);
    if (sources.size() <= kTreeLimits.leaf) {
      nodes_[at].count = static_cast<std::int32_t>(sources.size());
      return;
    }
    const std::size_t half =
        halve(sources, [](const SizeSource& source) { return middle_of(source.box); });
    divide(sources.first(half));
    nodes_[at].second = static_cast<std::int32_t>(nodes_.size());
    divide(sources.subspan(half));
  }

  /// Lowers `least` to the least that the sources at and below a node ask for at p.
  void search(const Vec3& p, Least& least, std::int32_t at = 0) const {
    const Node& node = nodes_[at];
    if (node.count > 0) {
      for (std::int32_t s = node.begin; s < node.begin + node.count; ++s)
        if (const double size = sources_[s].at(p, limits_, least.size); size < least.size) {
          least.size = size;
          least.source = s;
        }
      return;
    }
    std::int32_t near = at + 1, far = node.second;
    double to_near = distance2(nodes_[near].box, p), to_far = distance2(nodes_[far].box, p);
    if (to_far < to_near) {
      std::swap(near, far);
      std::swap(to_near, to_far);
    }
    if (may_have_less(nodes_[near], to_near, least)) search(p, least, near);
    if (least.size < least.sought) return;
    if (may_have_less(nodes_[far], to_far, least)) search(p, least, far);
  }

  SizeLimits limits_;
  std::vector<SizeSource> sources_;
  double steepest_ = 0;
  std::vector<Node> nodes_;
  BoxGrid grid_;
  std::vector<std::int32_t> begin_at_;  ///< by cell: the source to try first; -1: the base holds
};

/// A tree that is built at its first use: an edit that keeps all tets never uses it.
class SizeField::LazyTree {
 public:
  LazyTree(const SizeLimits& limits, std::vector<SizeSource> sources, const Box& bounds)
      : limits_(limits),
        sources_(std::move(sources)),
        bounds_(bounds),
        bytes_(Tree::bytes(sources_.size(), bounds)) {}

  [[nodiscard]] const Tree& operator*() const {
    if (const Tree* tree = ready_.load(std::memory_order_acquire)) return *tree;
    std::call_once(made_, [&] {
      tree_.emplace(limits_, std::move(sources_), bounds_);
      ready_.store(&*tree_, std::memory_order_release);
    });
    return *tree_;
  }
  /// Memory of the tree once it is built.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  SizeLimits limits_;
  mutable std::vector<SizeSource> sources_;  ///< until the tree is built
  Box bounds_;
  std::size_t bytes_;
  mutable std::once_flag made_;
  mutable std::optional<Tree> tree_;
  mutable std::atomic<const Tree*> ready_ = nullptr;  ///< the tree, once it is built
};

SizeField::SizeField(double base) : limits_{base, base, 0} {}

SizeField::SizeField(const SizeLimits& limits, std::vector<SizeSource> sources, const Box& bounds)
    : limits_(limits) {
  std::erase_if(sources, [&](const SizeSource& s) {
    return !s.varies() && std::fmax(s.size, s.wanted) >= limits.base;
  });
  double least = limits.base, asked = limits.base;
  for (const SizeSource& s : sources) {
    asked_ |= s.asked;
    double& of_its_kind = s.asked ? asked : least;
    of_its_kind = std::fmin(of_its_kind, s.varies() ? limits.least : s.size);
  }
  limits_.least = std::fmax(least, std::fmin(limits.least, limits.base));
  if (!sources.empty())
    tree_ = std::make_shared<const LazyTree>(limits_, std::move(sources), bounds);
  limits_.least = std::fmin(limits_.least, asked);
}

SizeField SizeField::refined(std::span<const Vec3> places, double share, const Box& bounds) const {
  SizeLimits limits = limits_;
  if (even()) limits.slope = kRefinement.slope;
  std::vector<SizeSource> sources;
  if (!even()) sources = (**tree_).sources();
  for (SizeSource& source : sources)
    if (!source.varies() && !source.asked) source.size = std::fmax(source.size, (**tree_).least());
  for (const Vec3& p : places) {
    const double size = share * (*this)(p);
    sources.push_back({std::array<Vec3, 3>{p, p, p}, {p, p}, size});
    limits.least = std::fmin(limits.least, size);
  }
  return SizeField(limits, std::move(sources), bounds);
}

std::size_t SizeField::bytes() const { return even() ? 0 : tree_->bytes(); }

double SizeField::asked_for(const Vec3& p, double enough) const {
  return even() ? enough : (**tree_)(p, enough);
}

bool SizeField::is_below(const Vec3& p, double length) const {
  return limits_.base < length || (!even() && (**tree_).any_below(p, length));
}

bool SizeField::is_asked_below(const Vec3& p, double length) const {
  return asked_ && (**tree_).least_is_asked(p, length);
}

double SizeField::bound(const Vec3& p) const {
  return even() ? limits_.base : (**tree_).of_one(p, limits_.base);
}

double SizeField::operator()(const Vec3& p) const {
  return even() ? limits_.base : (**tree_)(p, limits_.base);
}

double SizeField::grid_length() const { return std::sqrt(limits_.base * limits_.least); }

SizeField::Range SizeField::in(const Box& box) const {
  return even() ? Range{limits_.base, limits_.base} : around(asked_for(middle_of(box)), box);
}

SizeField::Range SizeField::around(double asked, const Box& box) const {
  const double reach = (**tree_).steepest() * 0.5 * box.diagonal();
  return {std::clamp(asked - reach, limits_.least, limits_.base),
          std::clamp(asked + reach, limits_.least, limits_.base)};
}

bool SizeField::EvenPart::holds(const Vec3& p) const {
  const auto along = [&](double Vec3::*axis) {
    const double v = std::clamp(p.*axis, whole.lo.*axis, whole.hi.*axis);
    return v >= box.lo.*axis && (v < box.hi.*axis || box.hi.*axis == whole.hi.*axis);
  };
  return along(&Vec3::x) && along(&Vec3::y) && along(&Vec3::z);
}

Box SizeField::EvenPart::reach(const Box& bounds) const {
  Box all = box;
  for (const auto axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    if (box.lo.*axis == whole.lo.*axis) all.lo.*axis = bounds.lo.*axis;
    if (box.hi.*axis == whole.hi.*axis) all.hi.*axis = bounds.hi.*axis;
  }
  return all;
}

std::vector<SizeField::EvenPart> SizeField::even_parts(const Box& box,
                                                       const Surface& surface) const {
  if (even()) return {{box, box, limits_.base}};
  std::vector<EvenPart> parts;
  divide(box, box, surface, parts);
  return parts;
}

void SizeField::divide(const Box& box, const Box& whole, const Surface& surface,
                       std::vector<EvenPart>& parts) const {
  const Vec3 middle = middle_of(box);
  const double off = std::fabs(signed_distance(surface, middle)) - 0.5 * box.diagonal();
  if (off > limits_.base) return;  // cheaper than a query of the field
  const double asked = asked_for(middle);
  const Range range = around(asked, box);
  if (off > range.greatest) return;
  const double length = std::fmin(asked, limits_.base);
  const Vec3 sides = box.hi - box.lo;
  const double longest = std::max({sides.x, sides.y, sides.z});
  if (range.greatest <= kParts.even * range.least || longest <= kParts.least * length) {
    parts.push_back({box, whole, length});
    return;
  }
  const auto axis = sides.x == longest ? &Vec3::x : sides.y == longest ? &Vec3::y : &Vec3::z;
  Box low = box, high = box;
  low.hi.*axis = high.lo.*axis = 0.5 * (box.lo.*axis + box.hi.*axis);
  divide(low, whole, surface, parts);
  divide(high, whole, surface, parts);
}

}  // namespace remeshd
