#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/run.h"
#include "engine/nodes/nearest.h"

namespace remeshd {

/// The node nearest to each of some fixed points, while nodes move and are added. An answer is kept
/// until its node moves or another comes nearer, so that few queries of the nodes' grid are needed
/// once most nodes have settled.
class NearestToPoints {
 public:
  /// `cell`: width of a cell of the nodes' grid, > 0.
  NearestToPoints(std::vector<Vec3> points, double cell);

  /// Tells where all nodes are now; new ones come last.
  void follow(std::span<const Vec3> nodes);

  /// The node nearest to a point, the lowest index where several are equally near; -1 if there are
  /// none.
  [[nodiscard]] std::int32_t nearest(std::uint32_t point);
  /// The same for many points; answers that are not known are looked up on several threads.
  [[nodiscard]] std::vector<std::int32_t> nearest(std::span<const std::uint32_t> points,
                                                  const Run& run);

  [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }
  [[nodiscard]] const NearestNode& grid_of_points() const { return point_grid_; }
  [[nodiscard]] const NearestNode& grid_of_nodes();

 private:
  struct Answer {
    std::int32_t node = -1;
    std::uint32_t given = 0;  ///< value of `now_` when it was found; 0: the answer is not valid
    double distance2 = 0;     ///< squared; no node has come nearer since
  };

  /// Whether an answer still holds.
  [[nodiscard]] bool stands(const Answer& a) const {
    return a.given > all_moved_ && moved_[a.node] <= a.given;
  }
  /// Makes a node that has moved the answer of the points that it has come nearest to.
  void look_again_near(std::int32_t node);
  [[nodiscard]] Answer look_up(const NearestNode& grid, std::uint32_t point) const;

  std::vector<Vec3> points_;
  NearestNode point_grid_;
  double reach_;                 ///< an answer further away than this is not kept
  std::vector<Answer> answers_;  ///< by point
  std::vector<Vec3> nodes_;
  std::vector<std::uint32_t> moved_;  ///< by node: time of its last move
  std::uint32_t now_ = 0;
  std::uint32_t all_moved_ = 0;  ///< last time that many nodes moved: older answers are not valid
  NearestNode node_grid_;
  std::vector<std::int32_t> behind_;  ///< nodes that have moved since `node_grid_` was updated
  std::vector<std::uint8_t> is_behind_;
};

}  // namespace remeshd
