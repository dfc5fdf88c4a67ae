#include "engine/nodes/copy_nodes.h"

#include <algorithm>

namespace remeshd {

namespace {

/// How far into a tet, as a share of the way to its centroid, the material next to a node is tried.
constexpr double kInto = 0.01;

/// For each node its tets, by node.
struct Incidence {
  std::vector<std::uint32_t> begin;
  std::vector<std::int32_t> tets;
};

Incidence tets_at_boundary_nodes(const OriginalNodes& original) {
  Incidence at;
  at.begin.assign(original.positions.size() + 1, 0);
  const auto wanted = [&](std::int32_t n) {
    return original.supports[n].kind != Support::Kind::Interior;
  };
  for (const Tet& t : original.tets)
    for (const std::int32_t n : t)
      if (wanted(n)) ++at.begin[n + 1];
  for (std::size_t n = 1; n < at.begin.size(); ++n) at.begin[n] += at.begin[n - 1];
  at.tets.resize(at.begin.back());
  std::vector<std::uint32_t> next(at.begin.begin(), at.begin.end() - 1);
  for (std::size_t k = 0; k < original.tets.size(); ++k)
    for (const std::int32_t n : original.tets[k])
      if (wanted(n)) at.tets[next[n]++] = static_cast<std::int32_t>(k);
  return at;
}

/// Transformations in the order in which their features copy.
std::vector<std::int32_t> copying_order(const PointSource& source) {
  std::vector<std::int32_t> order;
  for (const SourceFeature& s : source.sources())
    if (std::find(order.begin(), order.end(), s.transform) == order.end())
      order.push_back(s.transform);
  return order;
}

}  // namespace

NodeSet copy_nodes(const PointSource& source, const OriginalNodes& original, const Run& run) {
  NodeSet nodes;
  const Incidence at = tets_at_boundary_nodes(original);
  const std::vector<std::int32_t> order = copying_order(source);
  const double margin = source.probe();
  // The original extent of all features that a transformation moves.
  std::vector<std::vector<Box>> extent(source.transforms().size());
  for (const SourceFeature& s : source.sources())
    extent[s.transform].push_back(source.original()->solids()[s.original].bounds());

  const auto carried = [&](std::int32_t n, std::int32_t t) {
    const Transform& x = source.transforms()[t];
    const Vec3& q = original.positions[n];
    if (original.supports[n].kind == Support::Kind::Interior) return source(x.apply(q)) == t;
    for (std::uint32_t k = at.begin[n]; k < at.begin[n + 1]; ++k) {
      const Tet& tet = original.tets[at.tets[k]];
      const Vec3 centroid = 0.25 * (original.positions[tet[0]] + original.positions[tet[1]] +
                                    original.positions[tet[2]] + original.positions[tet[3]]);
      if (source(x.apply(q + kInto * (centroid - q))) == t) return true;
    }
    return false;
  };

  for (std::int32_t n = 0; n < static_cast<std::int32_t>(original.positions.size()); ++n) {
    if (n % 1024 == 0) run.poll();
    for (const std::int32_t t : order) {
      const Vec3& q = original.positions[n];
      const bool reached = std::any_of(extent[t].begin(), extent[t].end(),
                                       [&](const Box& box) { return box.contains(q, margin); });
      if (!reached || !carried(n, t)) continue;
      nodes.positions.push_back(source.transforms()[t].apply(q));
      nodes.supports.push_back(original.supports[n]);
      nodes.free.push_back(0);
      nodes.original.push_back(n);
      nodes.transform.push_back(t);
      break;
    }
  }
  return nodes;
}

}  // namespace remeshd
