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
/// Delaunay only if it is not much more than a right angle that it sees the link under: no node of
/// the faces beside it may stand in the ball on the link.
class CrowdedLinks {
 public:
  /// Keeps references; `nodes` change.
  CrowdedLinks(NodeSet& nodes, const BoundaryModel& boundary, const SizeField& sizes);

  /// Does away with the node nearest to the middle of the missing link of `edge` from a to b, of
  /// those in the ball on it. One of a face or of the inside moves onto the link. To one of another
  /// model edge, which runs beside the link as edges of a strip do or as those of a sharp corner,
  /// the link gets a node opposite; where the link has one next to that place, at its end, the
  /// other node moves opposite to that. Returns whether something has changed.
  bool clear(std::int32_t edge, std::int32_t a, std::int32_t b);
  /// The same for a link that verification misses, which is halved where no node is in its way.
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
  /// The place on the model edge at a part of the link, where its projection lies between its ends.
  [[nodiscard]] std::optional<Vec3> place_on(const Link& link, double part) const;
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
