#pragma once

#include <cstdint>

/// What `run_tetgen` and the program `remeshd-tetgen` say to each other over one socket: the
/// request in, one answer back, both in the machine's own byte order, for they are built together.
///
///   request  RequestHeader, points x 3 doubles, triangles x 3 int32; unless Task::Fill also
///            triangles x 1 int32 (markers), segments x 2 int32, segments x 1 int32 (markers)
///   answer   AnswerHeader, points x 3 doubles, tets x 4 int32, tets x 1 int32 (regions; 0 unless
///            Task::Fill), facets x 3 int32, facets x 1 int32 (markers), segments x 2 int32,
///            segments x 1 int32 (markers)
///
/// Arguments of the program: its limits on address space (bytes) and on processor time (s).
namespace remeshd::kernel::tetgen_protocol {

inline constexpr std::uint64_t kRequestMagic = 0x3271746873656D72;  // "rmeshtq2"
inline constexpr std::uint64_t kAnswerMagic = 0x3261746873656D72;   // "rmeshta2"

enum class Task : std::uint64_t {
  Fill = 0,              ///< the constrained Delaunay mesh, regions numbered: `pAQ`
  MeshKeepingSurface,    ///< a quality mesh whose boundary is the surface as it is: `pYq..a..Q`
  MeshSplittingSurface,  ///< the same with points added on the surface too: `pq..a..Q`
};

struct RequestHeader {
  std::uint64_t magic = kRequestMagic;
  std::uint64_t points = 0, triangles = 0, segments = 0;
  Task task = Task::Fill;
  double radius_edge = 0, max_volume = 0;  ///< of a quality mesh, as in TetGenQuality
  std::uint64_t most_added = 0;            ///< likewise
};

enum class Status : std::uint64_t {
  Meshed = 0,
  OutOfMemory = 1,  ///< TetGen's own number for it, like the next five
  InternalError = 2,
  SelfIntersection = 3,
  SmallFeature = 4,
  CloseFacets = 5,
  InputError = 10,
  BadNumber = 100,  ///< a coordinate that is not finite, or an index without a point
  Unknown = 101,
};

struct AnswerHeader {
  std::uint64_t magic = kAnswerMagic;
  Status status = Status::Unknown;
  std::uint64_t points = 0, tets = 0, facets = 0, segments = 0;
};

}  // namespace remeshd::kernel::tetgen_protocol
