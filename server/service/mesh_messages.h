#pragma once

#include <cstdint>
#include <vector>

#include "remesh/v1/mesh.pb.h"
#include "server/session/held_revision.h"

namespace remeshd {

/// The messages of a mesh, one after the other: header, parts, end. Arrays are taken straight from
/// the revision's memory; the same revision gives the same messages.
class MeshMessages {
 public:
  /// Works out what digests of the arrays are not known yet: not for a thread that others wait for.
  /// Throws Error: OPTIONS_INVALID for an unknown array, UNSUPPORTED for one that no mesh has and
  /// for deltas.
  MeshMessages(HeldRevisionPtr revision, const remesh::v1::MeshSelection& selection);

  /// Fills in the next message; false after the last.
  bool next(remesh::v1::MeshMessage& message);

 private:
  void put_header(remesh::v1::MeshHeader& header) const;
  void put_part(remesh::v1::MeshPart& part);

  HeldRevisionPtr revision_;
  std::vector<MeshArray> arrays_;
  bool begun_ = false, ended_ = false;
  std::size_t array_ = 0;     ///< next part: in which array
  std::uint64_t offset_ = 0;  ///< and where in it
  std::uint64_t bytes_ = 0;
  std::uint32_t parts_ = 0;
};

/// Arrays that a mesh of this daemon may have.
std::vector<remesh::v1::MeshArray> supported_arrays();

}  // namespace remeshd
