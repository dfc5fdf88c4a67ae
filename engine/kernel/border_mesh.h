#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace remeshd::kernel {

/// The polylines of a face's edges, in coordinates in which the face is flat.
struct Border {
  struct Corner {
    std::array<double, 2> p{};
    int node = -1;  ///< the caller's number
  };
  struct Segment {
    int a = -1, b = -1;  ///< corners
    int edge = -1;       ///< the caller's number; -1: on no edge, as at a pole
    int index = -1;      ///< in the polyline of the edge; -1 where the caller needs none
    int uses = 1;        ///< 2: the face lies on both sides
  };
  std::vector<Corner> corners;
  std::vector<Segment> segments;
};

/// Constrained Delaunay triangulation of the region within the border, with the points `inner`. A
/// place is within where a path to it from outside crosses an odd number of segments, each counted
/// `uses` times. Triangles turn counter-clockwise. Their indices: k below border.corners.size() is
/// corner k of the border, larger ones are `inner`[k - border.corners.size()].
///
/// Returns nothing where segments cross or touch each other away from their corners, a segment ends
/// where it begins, two segments have the same corners, points coincide, or the segments do not
/// close a region off.
std::optional<std::vector<std::array<int, 3>>> mesh_border(
    const Border& border, std::span<const std::array<double, 2>> inner);

/// Pairs of segments, by number, that cross, touch or lie on each other elsewhere than at a common
/// corner.
std::vector<std::pair<int, int>> crossing_segments(const Border& border);

}  // namespace remeshd::kernel
