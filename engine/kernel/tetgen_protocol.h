#pragma once

#include <cstdint>

/// What `run_tetgen` and the program `remeshd-tetgen` say to each other over one socket: the
/// request in, one answer back, both in the machine's own byte order, for they are built together.
///
///   request  RequestHeader, points x 3 doubles, triangles x 3 int32
///   answer   AnswerHeader, points x 3 doubles, tets x 4 int32, tets x 1 int32 (regions)
///
/// Arguments of the program: its limits on address space (bytes) and on processor time (s).
namespace remeshd::kernel::tetgen_protocol {

inline constexpr std::uint64_t kRequestMagic = 0x3171746873656D72;  // "rmeshtq1"
inline constexpr std::uint64_t kAnswerMagic = 0x3161746873656D72;   // "rmeshta1"

struct RequestHeader {
  std::uint64_t magic = kRequestMagic;
  std::uint64_t points = 0, triangles = 0;
};

enum class Status : std::uint64_t {
  Meshed = 0,
  OutOfMemory = 1,
  InternalError = 2,  ///< TetGen's own number for it, like the next four
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
  std::uint64_t points = 0, tets = 0;
};

}  // namespace remeshd::kernel::tetgen_protocol
