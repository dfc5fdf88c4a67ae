#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/boundary/samples.h"
#include "engine/nodes/nearest_to_points.h"
#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"

namespace remeshd {

/// How two faces, or two edges, meet.
enum class Meeting { Apart, Blunt, Sharp };

/// Which faces share an edge and which edges share a vertex, and whether they meet sharply there:
/// somewhere at less than 60 degrees. A node that is pulled on by two faces (edges) that meet
/// bluntly is not split (Sect. 3.3).
class Adjacency {
 public:
  explicit Adjacency(const BoundaryModel& boundary);
  /// `kind` is Face or Edge.
  [[nodiscard]] Meeting meeting(Support::Kind kind, int a, int b) const;

 private:
  std::vector<std::vector<int>> faces_, edges_, sharp_faces_, sharp_edges_;  ///< ascending
};

struct PullOptions {
  SizeField sizes{0};  ///< target edge lengths
  /// Two faces (edges) that meet sharply split a node where they pull it to places at least this
  /// share of the edge length apart: one node cannot serve both sides of a narrow wedge.
  double split_distance = 0.3;
  double split_ratio = 0.25;  ///< weaker to stronger pull above which a node is split
  /// Share of the edge length beyond which a model vertex does not pull in a node but gets a new
  /// one.
  double vertex_reach = 0.75;
  bool split = true;  ///< whether nodes may be split; vertices may get new ones all the same
  /// Share of the edge length beyond which samples of faces and edges pull on no node.
  double reach = HUGE_VAL;
};

/// The boundary procedure of one iteration (Sect. 3.3): faces pull first, then edges, then
/// vertices. Free nodes that nothing pulls on become interior; the others move to the weighted mean
/// of the samples that pull on them, projected on their face or edge. Where several faces (edges)
/// pull on a node, it goes to the one with the largest weight. Another of them with at least
/// `split_ratio` of that weight gets a new node if the two are not adjacent, or if they meet
/// sharply and pull to places at least `split_distance` apart. Fixed and frozen nodes stay, and
/// samples nearest to them have no effect; only a model vertex without a node takes the nearest one
/// within `vertex_reach`, which becomes free.
///
/// `nearest`: of the samples' positions; it is brought up to date with the nodes.
/// `active`: indices of the samples that take part, ascending.
/// Returns the indices of face and edge samples whose nearest node was free and of all vertex
/// samples that took part, ascending.
std::vector<std::uint32_t> pull_boundary(NodeSet& nodes, const BoundaryModel& boundary,
                                         const Adjacency& adjacency, const Samples& samples,
                                         std::span<const std::uint32_t> active,
                                         NearestToPoints& nearest, const PullOptions& options,
                                         const Run& run);

}  // namespace remeshd
