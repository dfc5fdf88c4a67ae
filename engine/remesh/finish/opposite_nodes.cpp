#include "engine/remesh/finish/opposite_nodes.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/mesh/grouping.h"

namespace remeshd {
namespace {

struct OppositeLimits {
  double around = 3;       ///< x edge length: how far from a defect
  double across = 0.5;     ///< x edge length: between a node and its image, at most
  double thinnest = 1e-4;  ///< x edge length: between a node and its image, at least
  double facing = 0.8;     ///< cosine between a normal and minus the other, at least
  double partner = 0.6;    ///< x edge length: between an image and a node that moves to it
  double room = 0.35;      ///< x edge length: from a new node to any other of its face
  double apart = 0.1;      ///< x edge length: from a node that moves to any other of its face
  double same = 1e-3;      ///< x edge length: a node so near to an image need not move
  double off_face = 0.05;  ///< x edge length: of an image from a face's triangles, for their chords
  int rounds = 3;          ///< of the search for an image on a curved face
};
constexpr OppositeLimits kOpposite;

}  // namespace

OppositeNodes::OppositeNodes(NodeSet& nodes, const BoundaryModel& boundary, const SizeField& sizes)
    : nodes_(nodes),
      boundary_(boundary),
      sizes_(sizes),
      faces_of_(boundary),
      grid_(nodes.positions, kGridCell * sizes.grid_length()) {}

int OppositeNodes::set(std::span<const MeshDefect> defects) {
  std::vector<Image> images;
  for (const std::int32_t n : nodes_near(defects))
    if (const std::optional<Image> nearest = nearest_image(n)) images.push_back(*nearest);
  std::vector<std::uint8_t> has_partner(nodes_.size(), 0);
  const int moved = move(images, has_partner);
  return moved + insert(images, has_partner);
}

std::vector<std::int32_t> OppositeNodes::nodes_near(std::span<const MeshDefect> defects) const {
  std::vector<std::int32_t> near;
  for (const MeshDefect& defect : defects)
    grid_.for_each_within(defect.place, kOpposite.around * sizes_(defect.place),
                          [&](std::int32_t n, double) {
                            if (nodes_.supports[n].kind != Support::Kind::Interior)
                              near.push_back(n);
                          });
  sort_unique(near);
  return near;
}

std::optional<OppositeNodes::Image> OppositeNodes::nearest_image(std::int32_t node) const {
  const Support& own = nodes_.supports[node];
  const Vec3& p = nodes_.positions[node];
  const double edge_length = sizes_(p);
  std::vector<std::int32_t> faces;
  grid_.for_each_within(p, (kOpposite.across + kOpposite.partner) * edge_length,
                        [&](std::int32_t n, double) {
                          const std::span<const int> of_node = faces_of_(nodes_.supports[n]);
                          faces.insert(faces.end(), of_node.begin(), of_node.end());
                        });
  sort_unique(faces);
  std::optional<Image> nearest;
  double least = kOpposite.across * edge_length;
  for (const std::int32_t f : faces) {
    if (incident(boundary_, own, {Support::Kind::Face, f})) continue;
    const std::optional<Vec3> place = image(node, f);
    const double d = place ? distance(*place, p) : 0;
    if (d < kOpposite.thinnest * edge_length || d >= least) continue;
    least = d;
    nearest = Image{node, f, *place, edge_length};
  }
  return nearest;
}

/// The image in a mirror whose normal is halfway between those of the faces, one of them reversed.
/// Nothing where the faces do not look at each other, or it is not on the face.
std::optional<Vec3> OppositeNodes::image(std::int32_t node, std::int32_t face) const {
  const Vec3& p = nodes_.positions[node];
  const BoundaryFace& to = boundary_.faces[face];
  const auto mirrored = [&](const Vec3& here) -> std::optional<Vec3> {
    Vec3 place = project(to.surface, p);
    for (int round = 0; round < kOpposite.rounds; ++round) {
      const Vec3 there = outward_normal(to, place);
      if (dot(here, there) > -kOpposite.facing) return std::nullopt;
      const Vec3 across = normalised(there - here);
      place = project(to.surface, p + dot(place - p, there) / dot(across, there) * across);
    }
    return place;
  };
  const double off = kOpposite.off_face * sizes_(p);
  for (const int own : faces_of_(nodes_.supports[node]))
    if (const auto place = mirrored(outward_normal(boundary_.faces[own], p)))
      if (face_distance2(to, *place) <= off * off) return place;
  return std::nullopt;
}

/// All pairs of an image and a node of its face near it, those at the least distance first.
std::vector<OppositeNodes::Pair> OppositeNodes::pairs_of(const std::vector<Image>& images) const {
  std::vector<Pair> pairs;
  for (std::int32_t i = 0; i < std::ssize(images); ++i) {
    const auto& [node, face, place, edge_length] = images[i];
    const Support on{Support::Kind::Face, face};
    grid_.for_each_within(place, kOpposite.partner * edge_length, [&](std::int32_t n, double d) {
      if (nodes_.supports[n] == on) pairs.push_back({std::sqrt(d) / edge_length, i, n});
    });
  }
  std::ranges::sort(pairs, {}, [](const Pair& p) { return std::tuple(p.cost, p.image, p.node); });
  return pairs;
}

int OppositeNodes::move(const std::vector<Image>& images, std::vector<std::uint8_t>& has_partner) {
  int moved = 0;
  for (const auto& [cost, i, node] : pairs_of(images)) {
    const Image& image = images[i];
    if (has_partner[image.node] != 0 || has_partner[node] != 0) continue;
    const bool stays = cost < kOpposite.same;
    if (!stays && (!may_move(node) || is_taken(image, kOpposite.apart, node))) continue;
    has_partner[image.node] = has_partner[node] = 1;
    if (stays) continue;
    nodes_.positions[node] = image.place;
    nodes_.state[node] = NodeState::Free;
    ++moved;
  }
  return moved;
}

int OppositeNodes::insert(const std::vector<Image>& images,
                          const std::vector<std::uint8_t>& has_partner) {
  const std::int32_t before = nodes_.size();
  for (const Image& image : images) {
    if (has_partner[image.node] != 0 || is_taken(image, kOpposite.room, -1)) continue;
    const bool near_new =
        std::any_of(nodes_.positions.begin() + before, nodes_.positions.end(), [&](const Vec3& p) {
          return distance(p, image.place) < kOpposite.room * image.edge_length;
        });
    if (!near_new) nodes_.add_new(image.place, {Support::Kind::Face, image.face});
  }
  return nodes_.size() - before;
}

/// Whether a node of the image's face, but for one, is nearer to the image than `room` x edge
/// length.
bool OppositeNodes::is_taken(const Image& image, double room, std::int32_t but) const {
  const Support on{Support::Kind::Face, image.face};
  bool taken = false;
  // The grid has nodes that have moved where they were before: it is searched further out.
  grid_.for_each_within(
      image.place, (room + kOpposite.partner) * image.edge_length, [&](std::int32_t n, double) {
        taken = taken || (n != but &&
                          distance(nodes_.positions[n], image.place) < room * image.edge_length &&
                          incident(boundary_, nodes_.supports[n], on));
      });
  return taken;
}

}  // namespace remeshd
