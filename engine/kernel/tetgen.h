#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/base/run.h"
#include "engine/mesh/tet_mesh.h"

namespace remeshd::kernel {

/// Triangles in any orientation that meet along whole edges; every part of space that they close
/// off is meshed, voids too.
struct TetGenSurface {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

struct TetGenMesh {
  TetMesh mesh;                       ///< fills what the surface closes off; flat tets are possible
  std::vector<std::int32_t> regions;  ///< per tet: the region between triangles that it lies in
};

using Segment = std::array<std::int32_t, 2>;

/// A surface with markers, which pass to the pieces that its triangles and segments are split into:
/// they tell where points were added.
struct MarkedSurface {
  TetGenSurface surface;
  std::vector<std::int32_t> triangle_markers;  ///< one for each triangle, > 0
  std::vector<Segment> segments;               ///< sides of triangles that have to stay edges
  std::vector<std::int32_t> segment_markers;   ///< one for each segment, > 0
};

/// What a quality mesh is to be like, as far as its surface allows.
struct TetGenQuality {
  double radius_edge = 1.2;  ///< circumradius of a tet over its shortest edge, at most
  /// Volume of a tet, model's unit cubed, at most. 0: neither this nor `radius_edge` counts, and
  /// points are added only where the surface cannot be recovered without them.
  double max_volume = 0;
  bool split_surface = true;  ///< whether points may be added on the surface
  /// Points; a mesh that takes so many is refused: TetGen stops there without a word. 0: no bound.
  std::uint32_t most_added = 0;
};

/// A quality mesh. Its first points are those of the surface, in their order, if all of these are
/// corners of triangles.
struct QualityMesh {
  TetGenMesh filling;
  std::vector<Triangle> facets;  ///< triangles of the mesh on the surface
  std::vector<std::int32_t> facet_markers;
  std::vector<Segment> segments;
  std::vector<std::int32_t> segment_markers;
};

/// What the child process may use.
struct TetGenLimits {
  double seconds = 60;                               ///< s from start to answer
  std::size_t address_space = std::size_t{2} << 30;  ///< bytes; a model takes some ten MB
  std::filesystem::path helper{};                    ///< empty: find_tetgen_helper()
};

/// The constrained Delaunay mesh of a surface by TetGen (`pAQ`), made by the program
/// `remeshd-tetgen`: TetGen may abort, hang or eat memory, and then only that process ends. Points
/// of the surface keep their coordinates; TetGen may add points on it.
///
/// Post: all indices are in range; no process, thread or file descriptor outlives the call.
/// Throws Error(TETGEN_REFUSED, TETGEN_CRASHED, TETGEN_TOO_SLOW, TETGEN_OUT_OF_MEMORY,
/// TETGEN_MISSING); Error(Cancelled) within 20 ms of a stop request. Source: Si 2015, TetGen;
/// Sect. 3.1 for its use.
TetGenMesh run_tetgen(const TetGenSurface& surface, const TetGenLimits& limits, const Run& run);

/// A mesh of well-shaped tets inside of the surface by TetGen (`pq..a..`, `pYq..a..`, `p`, `pY`) in
/// the same way. Points that no triangle has become nodes inside; TetGen may leave out or move some
/// of them. Where the surface has to stay as it is (Y) TetGen aborts on some:
/// Error(TETGEN_CRASHED).
///
/// Post: all indices are in range. Throws what the one above throws.
QualityMesh run_tetgen(const MarkedSurface& marked, const TetGenQuality& quality,
                       const TetGenLimits& limits, const Run& run);

/// How often TETGEN_CRASHED was thrown in this process, for whoever watches it.
std::uint64_t tetgen_crashes();

/// Where `remeshd-tetgen` is: $REMESHD_TETGEN if set, else beside the running program, else in
/// ../libexec/remeshd from there.
std::filesystem::path find_tetgen_helper();

}  // namespace remeshd::kernel
