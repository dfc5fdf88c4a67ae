#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/boundary/edge_chains.h"
#include "engine/nodes/nearest.h"
#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// Links of model edges between nodes that leave no room for another one. A facet beside a link is
/// Delaunay only if its angle opposite to the link is not much more than a right angle: no node of
/// the faces beside the link may stand in the ball whose diameter the link is.
class CrowdedLinks {
 public:
  /// Keeps references; `nodes` change.
  CrowdedLinks(NodeSet& nodes, const BoundaryModel& boundary, const SizeField& sizes);

  /// Makes room for the missing link of `edge` from a to b. Of the nodes in its ball the one
  /// nearest to its middle is in the way. If that is on a face or in the interior, it moves onto
  /// the link. If it is on another model edge, which runs beside the link as in a narrow strip or
  /// from a sharp corner, the link gets a node opposite to it; where that place is too near to an
  /// end of the link, the node in the way moves to be opposite to that end. Returns whether
  /// something has changed.
  bool clear(std::int32_t edge, std::int32_t a, std::int32_t b);
  /// The same for a link that verification found missing; it is halved where no node is in its way.
  bool clear(const MeshDefect& missing);

 private:
  struct Link {
    std::int32_t edge, a, b;
    double length;
  };
  [[nodiscard]] Link link_between(std::int32_t edge, std::int32_t a, std::int32_t b) const;
  [[nodiscard]] Vec3 middle_of(const Link& link) const {
    return 0.5 * (nodes_.positions[link.a] + nodes_.positions[link.b]);
  }
  /// The point of the model edge at a fraction of the link; nothing where it does not lie between
  /// the link's ends, well away from both.
  [[nodiscard]] std::optional<Vec3> place_on(const Link& link, double part) const;
  /// The node in the link's ball that is nearest to its middle, but for interface nodes and those
  /// that have changed; -1: none.
  [[nodiscard]] std::int32_t in_the_way(const Link& link) const;
  /// Direction of its model edge at a node, as a unit vector; 0 at a vertex.
  [[nodiscard]] Vec3 along(std::int32_t node) const;
  bool clear(const Link& link, std::int32_t node);
  bool split(const Link& link, double part);
  bool move_onto(const Link& link, std::int32_t node);
  bool set_opposite(const Link& link, std::int32_t node);
  void move(std::int32_t node, const Vec3& place, const Support& support);

  NodeSet& nodes_;
  const BoundaryModel& boundary_;
  const SizeField& sizes_;
  const NearestNode grid_;
  const std::vector<std::vector<NodeOnEdge>> chains_;
  std::vector<std::uint8_t> changed_;  ///< by node
};

}  // namespace remeshd
