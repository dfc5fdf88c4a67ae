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

/// Nodes of two faces that look at each other over half an edge length or less, as those of a film,
/// a narrow gap or a sharp wedge do. Facets of both are Delaunay where the nodes of one face are
/// mirror images of the other's: a ball round a facet, with its centre on the facet's side of the
/// mirror and no node of its own face in it, has no image of such a node in it either, because an
/// image is further from the centre than its node.
class OppositeNodes {
 public:
  /// Keeps references; `nodes` change.
  OppositeNodes(NodeSet& nodes, const BoundaryModel& boundary, const SizeField& sizes);

  /// Near the defects, moves nodes of a face to the mirror images, on this face, of nodes of other
  /// faces and edges; where none is near enough to an image to move, inserts a node there. Returns
  /// how many were moved and inserted.
  int set(std::span<const MeshDefect> defects);

 private:
  /// The mirror image of a node on a face that it does not stand on.
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
