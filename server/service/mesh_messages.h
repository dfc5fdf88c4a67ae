#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "remesh/v1/mesh.pb.h"
#include "server/session/held_revision.h"

namespace remeshd {

/// The data of a part, in pieces of memory that `owner` keeps alive.
struct PartData {
  std::vector<std::string_view> pieces;
  std::size_t bytes = 0;
  std::shared_ptr<const void> owner;
};

/// The messages of a mesh, one after the other: header, parts, end. Arrays are not copied out of
/// the revision; their deltas against the parent's are computed by the constructor. The same
/// revision and selection give the same messages.
class MeshMessages {
 public:
  /// Computes deltas, and digests of arrays that are not known yet, which takes time: not for a
  /// thread that must not be kept. `parent`: the base of deltas; null: the mesh comes whole.
  /// Throws what `check_selection` throws.
  MeshMessages(HeldRevisionPtr revision, const HeldRevisionPtr& parent,
               const remesh::v1::MeshSelection& selection);

  /// Leaves out the data before a position. Pre: `next` was not called yet.
  /// Throws Error: OPTIONS_INVALID where the selection has no such position.
  void resume_from(const remesh::v1::MeshPosition& position);

  /// Fills in the next message; the data of a part go to `data` only. False after the last message.
  bool next(remesh::v1::MeshMessage& message, PartData& data);
  /// Bytes that the messages take in memory beside the revision.
  [[nodiscard]] std::uint64_t own_bytes() const;
  /// Whether the last message was taken.
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  struct Sent {
    MeshArray array;
    remesh::v1::MeshHeader::Encoding encoding = remesh::v1::MeshHeader::ENCODING_WHOLE;
    std::uint64_t bytes = 0;  ///< of the data
    std::string delta;        ///< the data, for ENCODING_DELTA
  };
  struct Content {
    HeldRevisionPtr revision;
    std::vector<Sent> arrays;
  };

  void take_difference(Sent& sent, const HeldRevision& parent,
                       const std::vector<MeshArray>& of_parent);
  void put_header(remesh::v1::MeshHeader& header) const;
  void put_part(remesh::v1::MeshPart& part, PartData& data);

  std::shared_ptr<Content> content_;  ///< owns the data of parts; not changed after construction
  std::string base_;                  ///< id of the parent, where an array needs it
  bool begun_ = false, ended_ = false;
  std::size_t array_ = 0;     ///< next part: in which array
  std::uint64_t offset_ = 0;  ///< and where in it
  std::uint64_t bytes_ = 0;
  std::uint32_t parts_ = 0;
};

/// Throws Error: OPTIONS_INVALID for an unknown array.
void check_selection(const remesh::v1::MeshSelection& selection);

/// Arrays that a mesh of this daemon may have.
std::vector<remesh::v1::MeshArray> supported_arrays();

}  // namespace remeshd
