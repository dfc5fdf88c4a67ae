#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/boundary/facet_faces.h"
#include "engine/nodes/nearest.h"
#include "engine/nodes/node_set.h"
#include "engine/sizing/size_field.h"
#include "engine/verify/verify.h"

namespace remeshd {

/// Nodes of two faces that look at each other over less than an edge length, as those of a film, a
/// narrow gap or a sharp wedge do. Facets of both are Delaunay where the nodes of one are mirror
/// images of the other's: a ball round a facet with no node of its own face in it has no image of
/// one in it either, because images are further from its centre.
class OppositeNodes {
 public:
  /// Keeps references; `nodes` change.
  OppositeNodes(NodeSet& nodes, const BoundaryModel& boundary, const SizeField& sizes);

  /// Near the defects, moves nodes of faces to the images of others, and of nodes of edges, and
  /// inserts nodes where none is near enough to move. Returns how many were moved and inserted.
  int set(std::span<const MeshDefect> defects);

 private:
  /// Where a face that a node does not stand on has its mirror image.
  struct Image {
    std::int32_t node, face;
    Vec3 place;
    double edge_length;
  };
  /// A node that may move to an image.
  struct Pair {
    double cost;  ///< distance, x edge length
    std::int32_t image, node;
  };
  [[nodiscard]] std::vector<std::int32_t> nodes_near(std::span<const MeshDefect> defects) const;
  [[nodiscard]] std::optional<Image> nearest_image(std::int32_t node) const;
  [[nodiscard]] std::optional<Vec3> image(std::int32_t node, std::int32_t face) const;
  [[nodiscard]] std::vector<Pair> pairs_of(const std::vector<Image>& images) const;
  [[nodiscard]] bool may_move(std::int32_t node) const {
    return node >= nodes_.interface_nodes && nodes_.state[node] != NodeState::Fixed;
  }
  int move(const std::vector<Image>& images, std::vector<std::uint8_t>& has_partner);
  int insert(const std::vector<Image>& images, const std::vector<std::uint8_t>& has_partner);
  [[nodiscard]] bool is_taken(const Image& image, double room, std::int32_t but) const;

  NodeSet& nodes_;
  const BoundaryModel& boundary_;
  const SizeField& sizes_;
  const FacesOf faces_of_;
  const NearestNode grid_;
};

}  // namespace remeshd
