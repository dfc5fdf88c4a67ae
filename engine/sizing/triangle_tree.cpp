#include "engine/sizing/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/cellular/boundary_model/face_distance.h"
#include "engine/sizing/box_tree.h"

namespace remeshd {

namespace {

constexpr std::size_t kLeaf = 4;  // a node with at most so many triangles has no children

Vec3 middle_of(const std::array<Vec3, 3>& c) { return (1.0 / 3) * (c[0] + c[1] + c[2]); }

}  // namespace

TriangleTree::TriangleTree(const BoundaryModel& boundary) {
  std::vector<Face> faces;
  for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
    const BoundaryFace& face = boundary.faces[f];
    if (face.triangles.empty()) continue;
    faces.push_back({box_of(face.points), static_cast<std::int32_t>(f),
                     static_cast<std::int32_t>(triangles_.size()),
                     static_cast<std::int32_t>(face.triangles.size())});
    for (const auto& t : face.triangles)
      triangles_.push_back({face.points[t[0]], face.points[t[1]], face.points[t[2]]});
  }
  if (!faces.empty()) divide(faces);
}

/// Adds the node of these faces, which it reorders, and its descendants.
void TriangleTree::divide(std::span<Face> faces) {
  if (faces.size() == 1) {
    const Face& face = faces.front();
    divide(std::span(triangles_).subspan(face.begin, face.count), face.id);
    return;
  }
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  for (const Face& face : faces) nodes_[at].box.add(face.box);
  const std::size_t half = halve(faces, [](const Face& face) { return middle_of(face.box); });
  divide(faces.first(half));
  nodes_[at].second = static_cast<std::int32_t>(nodes_.size());
  divide(faces.subspan(half));
}

/// Adds the node of these triangles of a face, which it reorders, and its descendants.
void TriangleTree::divide(std::span<Triangle> triangles, std::int32_t face) {
  const std::size_t at = nodes_.size();
  nodes_.push_back(
      {.begin = static_cast<std::int32_t>(triangles.data() - triangles_.data()), .face = face});
  for (const Triangle& t : triangles)
    for (const Vec3& corner : t) nodes_[at].box.add(corner);
  if (triangles.size() <= kLeaf) {
    nodes_[at].count = static_cast<std::int32_t>(triangles.size());
    return;
  }
  const std::size_t half = halve(triangles, [](const Triangle& t) { return middle_of(t); });
  divide(triangles.first(half), face);
  nodes_[at].second = static_cast<std::int32_t>(nodes_.size());
  divide(triangles.subspan(half), face);
}

class TriangleTree::Search {
 public:
  Search(const TriangleTree& tree, const Vec3& p, double within,
         std::span<const std::uint8_t> left_out)
      : tree_(tree), p_(p), left_out_(left_out), best2_(within * within), best_{within, p} {}

  Nearest found() {
    if (!tree_.nodes_.empty()) search(0);
    if (best_.found) best_.distance = std::sqrt(best2_);
    return best_;
  }

 private:
  void search(std::int32_t at) {
    const Node& node = tree_.nodes_[at];
    if (node.face >= 0 && left_out_[node.face] != 0) return;
    if (node.count > 0) {
      for (std::int32_t t = node.begin; t < node.begin + node.count; ++t) ask(t);
      return;
    }
    std::int32_t near = at + 1, far = node.second;
    double to_near = distance2(tree_.nodes_[near].box, p_);
    double to_far = distance2(tree_.nodes_[far].box, p_);
    if (to_far < to_near) {
      std::swap(near, far);
      std::swap(to_near, to_far);
    }
    if (to_near < best2_) search(near);
    if (to_far < best2_) search(far);
  }
  void ask(std::int32_t t) {
    const Vec3 at = nearest_on_triangle(p_, tree_.triangles_[t]);
    const double d2 = norm2(at - p_);
    if (d2 >= best2_) return;
    best2_ = d2;
    best_.at = at;
    best_.found = true;
  }

  const TriangleTree& tree_;
  Vec3 p_;
  std::span<const std::uint8_t> left_out_;
  double best2_;
  Nearest best_;
};

TriangleTree::Nearest TriangleTree::nearest(const Vec3& p, double within,
                                            std::span<const std::uint8_t> left_out) const {
  return Search(*this, p, within, left_out).found();
}

}  // namespace remeshd
