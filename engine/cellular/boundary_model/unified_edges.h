#pragma once

#include <vector>

#include "engine/base/surface.h"
#include "engine/kernel/brep.h"

namespace remeshd {

/// Which edges and vertices of a B-rep are there because of its geometry, and which only because
/// of the CAD kernel: seams of round faces, the point where a circle begins, splits of one surface
/// or curve.
struct UnifiedEdges {
  std::vector<std::vector<int>> faces_at_edge;  ///< selected faces, ascending; a seam's face twice
  std::vector<char> edge;       ///< by B-rep edge: 1 if surface, side or group changes across it
  std::vector<char> rim;        ///< by B-rep edge: 1 if only SelectedFace::group changes across it
  std::vector<char> vertex;     ///< by B-rep vertex: end or corner of such edges, or apex of a cone
  std::vector<int> face_group;  ///< by B-rep face: one number per unified face, -1 if not selected
  int groups = 0;               ///< number of unified faces
};

/// A selected face of a B-rep: its untrimmed surface and which way it is seen.
struct SelectedFace {
  bool selected = false;
  Surface surface;
  int side = 1;   ///< faces of different side are never unified
  int group = 0;  ///< nor are those of different group
};

/// Finds the unified edges and vertices of the selected faces; other faces are ignored. An edge
/// between two faces of one surface, side and group is none; where three or more faces meet there
/// always is one. A vertex at which no unified edge ends is a unified one only at the apex of a
/// cone.
///
/// Pre: one SelectedFace for each face of `brep`.
UnifiedEdges find_unified_edges(const kernel::Brep& brep, const std::vector<SelectedFace>& faces);

/// Whether two edge ends that meet continue one curve; `end` 0 is the start.
bool continues(const kernel::BrepEdge& a, int end_a, const kernel::BrepEdge& b, int end_b,
               double tolerance);

/// Length below which positions that the CAD kernel made count as equal, model's unit: ten times
/// the tolerance of the kernel itself.
double kernel_tolerance(const kernel::Brep& brep);

}  // namespace remeshd
