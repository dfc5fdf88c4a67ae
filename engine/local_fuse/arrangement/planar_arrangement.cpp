#include "engine/local_fuse/arrangement/planar_arrangement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "engine/base/angle.h"
#include "engine/kernel/curve_points.h"

namespace remeshd {
namespace {

// More would take longer than the kernel.
struct ArrangementLimits {
  std::size_t sides = 1500;  ///< pairs of them are looked at
  int searches = 10'000;     ///< for a node
};
constexpr ArrangementLimits kMost;

double distance_to_segment(const Vec3& p, const SweepSide& s) {
  const Vec3 d = s.to - s.from;
  return distance(p, s.from + std::clamp(dot(p - s.from, d) / norm2(d), 0.0, 1.0) * d);
}

/// The distance between a circle and a side, where an arc counts as its whole circle; negative
/// where they cross.
double gap(const SweepSide& circle, const SweepSide& side) {
  const Vec3& c = circle.centre;
  double nearest = 0, furthest = 0;  // of the side, from the circle's centre
  if (side.round) {
    const double d = distance(c, side.centre);
    nearest = std::fabs(d - side.radius);
    furthest = d + side.radius;
  } else {
    nearest = distance_to_segment(c, side);
    furthest = std::max(distance(c, side.from), distance(c, side.to));
  }
  return std::max(nearest - circle.radius, circle.radius - furthest);
}

class Arrangement {
 public:
  Arrangement(const Sweeps& sweeps, const Membership& membership, double diagonal)
      : sweeps_(sweeps),
        membership_(membership),
        same_(kSameOutline * diagonal),
        clear_(kClearOutline * diagonal) {
    for (int k = 0; k < static_cast<int>(sweeps.sweeps.size()); ++k)
      for (const SweepSide& side : sweeps.sweeps[k].sides) sides_.push_back({side, k, {}});
  }

  Tried<PlanarArrangement> arrange() {
    if (sides_.size() > kMost.sides)
      return GaveUp{"planar_arrangement", "the outlines have too many sides"};
    for (Placed& p : sides_) p.ends = {node(p.side.from), node(p.side.to)};
    for (std::size_t i = 0; !doubt_ && i < sides_.size(); ++i)
      for (std::size_t j = i + 1; !doubt_ && j < sides_.size(); ++j) meet(sides_[i], sides_[j]);
    for (Placed& p : sides_) p.side.round ? add_round(p) : add_line(p);
    if (doubt_) return *doubt_;
    for (ArrangementEdge& piece : out_.pieces) find_sides(piece);
    return std::move(out_);
  }

 private:
  struct Placed {
    SweepSide side;
    int sweep;
    std::array<int, 2> ends;
    std::vector<int> on = {};  ///< nodes on a line between its ends
    bool doubled = false;      ///< a circle that coincides with an earlier one
  };

  void doubt(const char* why) {
    if (!doubt_) doubt_ = GaveUp{"planar_arrangement", why};
  }

  int node(const Vec3& p) {
    if (++searches_ > kMost.searches) doubt("the sides have too many ends and crossings");
    for (int n = 0; n < static_cast<int>(out_.nodes.size()); ++n) {
      const double d = distance(out_.nodes[n], p);
      if (d <= same_) return n;
      if (d < clear_) doubt("two nodes are neither clearly the same nor clearly apart");
    }
    out_.nodes.push_back(p);
    return static_cast<int>(out_.nodes.size()) - 1;
  }

  void meet(Placed& a, Placed& b) {
    if (!a.side.round && !b.side.round) return meet_lines(a, b);
    // The sides of one outline do not cross; their chords are checked when faces are meshed.
    if (a.sweep == b.sweep) return;
    if (a.side.closed() && b.side.closed() && distance(a.side.centre, b.side.centre) <= same_ &&
        std::fabs(a.side.radius - b.side.radius) <= same_) {
      b.doubled = true;
      return;
    }
    const double between = a.side.round ? gap(a.side, b.side) : gap(b.side, a.side);
    const double radius = std::max(a.side.radius, b.side.radius);
    if (between < std::max(clear_, kernel::kClearChord * radius))
      doubt("a round side meets or nearly meets a side of another outline");
  }

  void meet_lines(Placed& a, Placed& b) {
    bool touch = false;
    for (Placed* p : {&a, &b}) {
      Placed& other = p == &a ? b : a;
      for (const int n : p->ends) {
        const double d = distance_to_segment(out_.nodes[n], other.side);
        if (d >= clear_) continue;
        touch = true;
        if (d > same_)
          doubt("the end of a side nearly touches another side");
        else if (n != other.ends[0] && n != other.ends[1])
          other.on.push_back(n);
      }
    }
    if (touch) return;  // lines with a common point cross nowhere else
    const Vec3 u = a.side.to - a.side.from, v = b.side.to - b.side.from;
    const Vec3 w = b.side.from - a.side.from;
    const double det = cross(u, v).z;
    if (std::fabs(det) <= 1e-9 * norm(u) * norm(v)) return;  // too nearly parallel to cross
    const double s = cross(w, v).z / det, t = cross(w, u).z / det;
    if (s <= 0 || s >= 1 || t <= 0 || t >= 1) return;
    const int n = node(a.side.from + s * u);
    a.on.push_back(n);
    b.on.push_back(n);
  }

  void add_round(const Placed& p) {
    const SweepSide& s = p.side;
    const ArrangementCover cover{p.sweep, s.face, s.left_turn};
    if (p.doubled) {
      const auto it = std::ranges::find_if(out_.pieces, [&](const ArrangementEdge& piece) {
        return piece.round && piece.a == piece.b && distance(piece.centre, s.centre) <= same_ &&
               std::fabs(piece.radius - s.radius) <= same_;
      });
      it->covers.push_back(cover);
      return;
    }
    ArrangementEdge piece{p.ends[0], p.ends[1], true, s.centre, s.radius, kTurn, {cover}, {}, {}};
    if (!s.left_turn) std::swap(piece.a, piece.b);
    if (piece.a != piece.b) {
      const Vec3 from = out_.nodes[piece.a] - s.centre, to = out_.nodes[piece.b] - s.centre;
      piece.angle = std::atan2(cross(from, to).z, dot(from, to));
      if (piece.angle <= 0) piece.angle += kTurn;
    } else if (!s.closed()) {
      doubt("the ends of an arc are one node");
    }
    out_.pieces.push_back(std::move(piece));
  }

  void add_line(Placed& p) {
    const Vec3& from = p.side.from;
    const Vec3 along = p.side.to - from;
    p.on.insert(p.on.end(), p.ends.begin(), p.ends.end());
    std::ranges::sort(p.on, {},
                      [&](int n) { return std::pair(dot(out_.nodes[n] - from, along), n); });
    p.on.erase(std::unique(p.on.begin(), p.on.end()), p.on.end());
    for (std::size_t i = 0; i + 1 < p.on.size(); ++i) {
      const std::array<int, 2> ends{std::min(p.on[i], p.on[i + 1]), std::max(p.on[i], p.on[i + 1])};
      const auto [it, fresh] = line_.try_emplace(ends, static_cast<int>(out_.pieces.size()));
      if (fresh) out_.pieces.push_back({.a = ends[0], .b = ends[1]});
      out_.pieces[it->second].covers.push_back({p.sweep, p.side.face, p.on[i] == ends[0]});
    }
  }

  /// Finds the sweeps left and right of a piece: those that it bounds by their covers; any other is
  /// on both sides or on none, as the middle of the piece tells.
  void find_sides(ArrangementEdge& piece) const {
    std::ranges::sort(piece.covers, {}, &ArrangementCover::sweep);
    Vec3 middle = 0.5 * (out_.nodes[piece.a] + out_.nodes[piece.b]);
    if (piece.round) {
      const Vec3 d = out_.nodes[piece.a] - piece.centre;
      const double c = std::cos(piece.angle / 2), s = std::sin(piece.angle / 2);
      middle = piece.centre + Vec3{c * d.x - s * d.y, s * d.x + c * d.y, 0};
    }
    for (int k = 0; k < static_cast<int>(sweeps_.sweeps.size()); ++k) {
      const auto cover = std::ranges::find(piece.covers, k, &ArrangementCover::sweep);
      bool left = false, right = false;
      if (cover != piece.covers.end()) {
        for (auto it = cover; it != piece.covers.end() && it->sweep == k; ++it)
          (it->left ? left : right) = true;
      } else {
        const Sweep& sweep = sweeps_.sweeps[k];
        const Vec3 p{middle.x, middle.y, 0.5 * (sweep.low + sweep.high)};
        left = right = membership_.contains(sweep.feature, sweeps_.frame.apply(p));
      }
      if (left) piece.left.push_back(k);
      if (right) piece.right.push_back(k);
    }
  }

  const Sweeps& sweeps_;
  const Membership& membership_;
  double same_, clear_;
  std::optional<GaveUp> doubt_;  ///< the first
  int searches_ = 0;
  std::vector<Placed> sides_;
  std::map<std::array<int, 2>, int> line_;  ///< lines among the pieces, by their nodes
  PlanarArrangement out_;
};

}  // namespace

Tried<PlanarArrangement> arrange(const Sweeps& sweeps, const Membership& membership,
                                 double diagonal) {
  return Arrangement(sweeps, membership, diagonal).arrange();
}

}  // namespace remeshd
