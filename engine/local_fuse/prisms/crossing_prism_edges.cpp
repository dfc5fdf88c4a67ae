#include "engine/local_fuse/prisms/crossing_prism_edges.h"

#include <algorithm>
#include <map>
#include <optional>

#include "engine/base/angle.h"
#include "engine/base/tolerance.h"

namespace remeshd {
namespace {

/// Whether the same half-faces, whatever their directions, lie round two points of a curve.
bool alike(const std::vector<HalfFace>& a, const std::vector<HalfFace>& b) {
  const std::size_t n = a.size();
  if (b.size() != n) return false;
  // Along an ellipse half-faces turn in the curve's frame, so that another may come first.
  for (std::size_t shift = 0; shift < n; ++shift) {
    bool same = true;
    for (std::size_t i = 0; same && i < n; ++i) {
      const HalfFace &p = a[i], &q = b[(i + shift) % n];
      same = p.before == q.before && p.behind == q.behind && p.covers == q.covers;
    }
    if (same) return true;
  }
  return n == 0;
}

/// Whether a single smooth face passes through the curve, and nothing else is there.
bool passes(const std::vector<HalfFace>& half_faces) {
  return half_faces.size() == 2 && half_faces[0].covers == half_faces[1].covers &&
         half_faces[0].before == half_faces[1].behind &&
         norm(half_faces[0].direction + half_faces[1].direction) < tolerance::kSameDirection;
}

class EdgeFinder {
 public:
  EdgeFinder(const std::vector<IntersectionCurve>& curves, const Sectors& sectors,
             const Clearance& clearance)
      : curves_(curves), sectors_(sectors), same_(clearance.same), clear_(clearance.clear) {}

  Tried<PrismEdges> find() {
    for (int c = 0; c < static_cast<int>(curves_.size()); ++c) {
      add_parts(c);
      if (doubt_) return *doubt_;
    }
    join_parts();
    return std::move(out_);
  }

 private:
  void doubt(const GaveUp& why) {
    if (!doubt_) doubt_ = why;
  }

  int node(const Vec3& p) {
    // The coordinate along a skew direction, which few nodes share, to look up those nearby.
    const double key = 0.5377 * p.x + 0.6113 * p.y + 0.5806 * p.z;
    for (auto it = by_key_.lower_bound(key - clear_);
         it != by_key_.end() && it->first <= key + clear_; ++it) {
      const double d = distance(out_.nodes[it->second], p);
      if (d <= same_) return it->second;
      if (d < clear_)
        doubt({"crossing_prism_edges", "two nodes are neither clearly the same nor clearly apart"});
    }
    out_.nodes.push_back(p);
    seam_.push_back(0);
    by_key_.emplace(key, static_cast<int>(out_.nodes.size()) - 1);
    return static_cast<int>(out_.nodes.size()) - 1;
  }

  /// The splits of a curve in order, each place once; of a round curve the first again at the end,
  /// a turn later.
  [[nodiscard]] std::vector<IntersectionCurve::Split> splits_of(
      const IntersectionCurve& curve) const {
    std::vector<IntersectionCurve::Split> all = curve.splits, out;
    if (curve.round)
      for (IntersectionCurve::Split& split : all) split.t = wrapped(split.t);
    std::ranges::sort(all, {}, &IntersectionCurve::Split::t);
    for (const IntersectionCurve::Split& split : all) {
      if (!out.empty() && distance(curve.at(out.back().t).p, curve.at(split.t).p) <= same_)
        out.back().seam = out.back().seam || split.seam;
      else
        out.push_back(split);
    }
    if (!curve.round || out.empty()) return out;
    if (out.size() > 1 && distance(curve.at(out.back().t).p, curve.at(out.front().t).p) <= same_) {
      out.front().seam = out.front().seam || out.back().seam;
      out.pop_back();
    }
    out.push_back({out.front().t + kTurn, out.front().seam});
    return out;
  }

  void add_parts(int c) {
    const IntersectionCurve& curve = curves_[c];
    const std::vector<IntersectionCurve::Split> splits = splits_of(curve);
    for (std::size_t i = 0; i + 1 < splits.size(); ++i) {
      const double from = splits[i].t, to = splits[i + 1].t, middle = 0.5 * (from + to);
      auto half_faces = sectors_.around(curve, middle);
      if (!half_faces) return doubt(half_faces.why());
      if (half_faces->empty() || (passes(*half_faces) && !is_seam(curve, *half_faces))) continue;
      if ((to - from) * norm(curve.at(middle).derivative) < clear_)
        doubt({"crossing_prism_edges", "an edge is very short"});
      const int a = node(curve.at(from).p), b = node(curve.at(to).p);
      if (splits[i].seam) seam_[a] = 1;
      if (splits[i + 1].seam) seam_[b] = 1;
      out_.edges.push_back({c, from, to, a, b, middle, *std::move(half_faces)});
    }
  }

  static bool is_seam(const IntersectionCurve& curve, const std::vector<HalfFace>& half_faces) {
    return std::ranges::any_of(half_faces.front().covers, [&](const Patch* cover) {
      return std::ranges::any_of(curve.seams, [&](const Patch* seam) { return seam == cover; });
    });
  }

  /// Makes one edge of two where nothing else ends between them.
  void join_parts() {
    std::vector<std::vector<int>> ends(out_.nodes.size());
    for (int e = 0; e < static_cast<int>(out_.edges.size()); ++e)
      for (const int n : {out_.edges[e].a, out_.edges[e].b}) ends[n].push_back(e);
    std::vector<char> gone(out_.edges.size(), 0);
    for (int n = 0; n < static_cast<int>(ends.size()); ++n) {
      if (seam_[n] != 0 || ends[n].size() != 2 || ends[n][0] == ends[n][1]) continue;
      int first = ends[n][0], second = ends[n][1];
      if (out_.edges[first].b != n) std::swap(first, second);
      PrismEdge &a = out_.edges[first], &b = out_.edges[second];
      if (a.curve != b.curve || a.b != n || b.a != n || !alike(a.half_faces, b.half_faces))
        continue;
      const double length = b.to - b.from;
      a.to += length;
      a.b = b.b;
      std::ranges::replace(ends[b.b], second, first);
      gone[second] = 1;
    }
    std::vector<PrismEdge> kept;
    for (std::size_t e = 0; e < gone.size(); ++e)
      if (!gone[e]) kept.push_back(std::move(out_.edges[e]));
    out_.edges = std::move(kept);
  }

  const std::vector<IntersectionCurve>& curves_;
  const Sectors& sectors_;
  double same_, clear_;
  std::optional<GaveUp> doubt_;        ///< the first
  std::multimap<double, int> by_key_;  ///< nodes by the key that `node` computes
  std::vector<char> seam_;             ///< by node: whether a seam has a vertex there, which stays
  PrismEdges out_;
};

}  // namespace

Tried<PrismEdges> find_prism_edges(const std::vector<IntersectionCurve>& curves,
                                   const Sectors& sectors, const Clearance& clearance) {
  return EdgeFinder(curves, sectors, clearance).find();
}

}  // namespace remeshd
