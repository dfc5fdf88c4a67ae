#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/checksum.h"
#include "remesh/v1/remesh.pb.h"
#include "server/session/held_revisions.h"

namespace remeshd {

/// The messages of GetMesh, one after the other: header, parts, end. Arrays are taken straight from
/// the revision's memory; the same revision gives the same messages.
class MeshMessages {
 public:
  /// `arrays`: those wanted; none means all. Throws Error(InvalidArgument) for an unknown one.
  MeshMessages(HeldRevisionPtr revision, const std::vector<remesh::v1::MeshArray>& arrays);

  /// Fills in the next message; false after the last.
  bool next(remesh::v1::MeshMessage& message);

 private:
  struct Array {
    remesh::v1::MeshArray name;
    std::uint32_t count;
    std::uint64_t bytes;
    /// The bytes from an offset on that lie together in memory: one at least.
    std::function<std::string_view(std::uint64_t)> from;
  };

  template <class T>
  void add(remesh::v1::MeshArray name, const Pages<T>& values);
  template <class T>
  void add(remesh::v1::MeshArray name, const std::vector<T>& values);
  void add_text(remesh::v1::MeshArray name, std::size_t count, std::string text);
  [[nodiscard]] bool wanted(remesh::v1::MeshArray name) const;
  void header(remesh::v1::MeshHeader& header) const;
  void part(remesh::v1::MeshPart& part);

  HeldRevisionPtr revision_;
  std::vector<remesh::v1::MeshArray> wanted_;
  std::vector<Array> arrays_;
  Sha256 sum_;
  bool begun_ = false, ended_ = false;
  std::size_t array_ = 0;     ///< next part: in which array
  std::uint64_t offset_ = 0;  ///< and where in it
  std::uint64_t bytes_ = 0;
  std::uint32_t parts_ = 0;
};

}  // namespace remeshd
