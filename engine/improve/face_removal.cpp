#include <algorithm>

#include "engine/improve/reconnect.h"

namespace remeshd {
namespace {

/// Facets between the apexes a and b, found outwards from the first one as a tree.
class Sandwich {
 public:
  Sandwich(const LocalMesh& mesh, const TetQuality& quality, std::int32_t a, std::int32_t b,
           double floor, Reconnection& out)
      : mesh_(mesh), quality_(quality), a_(a), b_(b), floor_(floor), out_(out) {}

  /// Goes on beyond the edge u-w of a facet that is taken out, which seen from a runs from u to w:
  /// either with the new tet (a, b, u, w), or, where that is not above the floor and it serves
  /// better, by taking out the next facet too and going on beyond its edges. Returns the quality of
  /// the worst fresh tet; sets `worst_old` to that of the worst tet that goes.
  double beyond(std::int32_t u, std::int32_t w, int depth, double& worst_old) {
    const double alone = quality_(mesh_.node(a_), mesh_.node(b_), mesh_.node(u), mesh_.node(w));
    worst_old = std::numeric_limits<double>::infinity();
    std::int32_t upper = -1;
    std::int32_t lower = -1;
    const std::int32_t x = depth > 0 && alone <= floor_ ? next(u, w, upper, lower) : -1;
    if (x >= 0) {
      const std::size_t fresh_mark = out_.fresh.size();
      const std::size_t old_mark = out_.old_tets.size();
      double old_ux = 0;
      double old_xw = 0;
      out_.old_tets.push_back(upper);
      out_.old_tets.push_back(lower);
      const double fresh =
          std::min(beyond(u, x, depth - 1, old_ux), beyond(x, w, depth - 1, old_xw));
      const double old = std::min({quality_(mesh_, upper), quality_(mesh_, lower), old_ux, old_xw});
      if (fresh > alone || fresh > old) {
        worst_old = old;
        return fresh;
      }
      out_.fresh.resize(fresh_mark);
      out_.old_tets.resize(old_mark);
    }
    out_.fresh.push_back({a_, b_, u, w});
    return alone;
  }

 private:
  static constexpr std::size_t kMaxTets = 16;

  /// The apex x with tets (a, u, x, w) and (b, u, x, w), so that the facet u-x-w lies between the
  /// apexes as well; -1 if there is none.
  std::int32_t next(std::int32_t u, std::int32_t w, std::int32_t& upper, std::int32_t& lower) {
    if (out_.old_tets.size() >= kMaxTets) return -1;
    upper = across_facet(a_, u, w);
    lower = across_facet(b_, u, w);
    if (upper < 0 || lower < 0 || upper == lower) return -1;
    const std::int32_t x = apex(upper, a_, u, w);
    return x == apex(lower, b_, u, w) ? x : -1;
  }

  /// The tet with the facet p-u-w that is not taken out already; -1 if there is none.
  std::int32_t across_facet(std::int32_t p, std::int32_t u, std::int32_t w) const {
    for (const std::int32_t t : mesh_.tets_of(u)) {
      const Tet& tet = mesh_.tet(t);
      if (std::find(tet.begin(), tet.end(), p) == tet.end()) continue;
      if (std::find(tet.begin(), tet.end(), w) == tet.end()) continue;
      const auto& old = out_.old_tets;
      if (std::find(old.begin(), old.end(), t) == old.end()) return t;
    }
    return -1;
  }
  [[nodiscard]] std::int32_t apex(std::int32_t t, std::int32_t p, std::int32_t u,
                                  std::int32_t w) const {
    for (const std::int32_t n : mesh_.tet(t))
      if (n != p && n != u && n != w) return n;
    return -1;
  }

  const LocalMesh& mesh_;
  const TetQuality& quality_;
  std::int32_t a_, b_;
  double floor_;
  Reconnection& out_;
};

}  // namespace

bool remove_faces(const LocalMesh& mesh, std::int32_t tet, int corner, double floor,
                  Reconnection& out, const TetQuality& quality) {
  constexpr int kMaxDepth = 3;
  const Tet& above = mesh.tet(tet);
  const std::int32_t a = above[corner];
  // Seen from a the facet turns u, v, w: the tet (a, u, v, w) is positive.
  const std::int32_t u = above[kTetFacets[corner][0]];
  const std::int32_t v = above[kTetFacets[corner][1]];
  const std::int32_t w = above[kTetFacets[corner][2]];
  const std::int32_t below = mesh.across(tet, u, v, w);
  if (below < 0) return false;
  std::int32_t b = -1;
  for (const std::int32_t n : mesh.tet(below))
    if (n != u && n != v && n != w) b = n;
  if ((mesh.locked(a) && mesh.locked(b)) || mesh.joined(a, b)) return false;

  out.clear();
  out.old_tets = {tet, below};
  Sandwich sandwich(mesh, quality, a, b, floor, out);
  double worst_old = std::min(quality(mesh, tet), quality(mesh, below));
  out.quality = std::numeric_limits<double>::infinity();
  for (const auto& [p, q] : {std::pair{u, v}, std::pair{v, w}, std::pair{w, u}}) {
    double old = 0;
    out.quality = std::min(out.quality, sandwich.beyond(p, q, kMaxDepth, old));
    worst_old = std::min(worst_old, old);
  }
  return out.quality > std::max(floor, worst_old);
}

}  // namespace remeshd
