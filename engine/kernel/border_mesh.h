#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace remeshd::kernel {

/// The polylines round a face, flattened.
struct Border {
  struct Corner {
    std::array<double, 2> p{};
    int node = -1;  ///< the caller's
  };
  struct Segment {
    int a = -1, b = -1;  ///< corners
    int edge = -1;       ///< the caller's; -1: at a pole
    int index = -1;      ///< in the polyline of the edge
    int uses = 1;        ///< 2: the face on both sides
  };
  std::vector<Corner> corners;
  std::vector<Segment> segments;
};

/// Triangulates what an odd number of segments parts from the outside, with these points inside, by
/// constrained Delaunay triangulation. The triangles' corners turn counter-clockwise; numbers from
/// the border's last on are of `inner`.
///
/// Returns nothing where segments cross or touch each other away from their corners.
std::optional<std::vector<std::array<int, 3>>> mesh_border(
    const Border& border, std::span<const std::array<double, 2>> inner);

/// Pairs of segments, by number, that cross, touch or lie on each other elsewhere than at a common
/// corner.
std::vector<std::pair<int, int>> crossing_segments(const Border& border);

}  // namespace remeshd::kernel
