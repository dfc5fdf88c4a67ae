// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "remesh/v1/remesh.pb.h"
#include "remeshd/mesh.h"

namespace remeshd::client {

/// Puts the messages of one mesh together and checks all of them: order, lengths, the CRC-32C of
/// each part, the digest of each array, counts and indices.
///
/// Every function throws CallError MESH_DAMAGED where something is wrong.
class MeshAssembler {
 public:
  /// `arrays`: those that must come; none: all that a Mesh has a place for. `bases`: meshes that
  /// deltas may be against; null pointers are passed over.
  explicit MeshAssembler(const std::vector<remesh::v1::MeshArray>& arrays = {},
                         std::vector<std::shared_ptr<const Mesh>> bases = {});

  void add(const remesh::v1::MeshMessage& message);
  [[nodiscard]] bool ended() const { return ended_; }
  /// Where to go on after a transfer that broke: the header comes once more, and then what has not
  /// come yet. Nothing where no header has come.
  [[nodiscard]] std::optional<remesh::v1::MeshPosition> resume();
  /// The mesh, once the end has come; nothing may be called after it.
  [[nodiscard]] Mesh finish();

  /// Bytes of data as they are sent: of deltas, not of the arrays that these make.
  [[nodiscard]] std::uint64_t bytes_received() const { return received_; }
  [[nodiscard]] std::uint64_t bytes_expected() const { return expected_; }

 private:
  void add_header_again(const remesh::v1::MeshHeader& header);
  void add_header(const remesh::v1::MeshHeader& header);
  void add_part(const remesh::v1::MeshPart& part);
  void add_end(const remesh::v1::MeshEnd& end);
  void check_entry(const remesh::v1::MeshHeader::Array& entry);
  void find_base();
  void end_array();
  [[nodiscard]] std::string decode(const remesh::v1::MeshHeader::Array& entry);

  std::set<remesh::v1::MeshArray> wanted_;
  std::vector<std::shared_ptr<const Mesh>> bases_;
  std::shared_ptr<const Mesh> base_;  ///< the one that the header names
  remesh::v1::MeshHeader header_;
  bool has_header_ = false;
  bool ended_ = false;
  int current_ = 0;          ///< place in the header of the array that comes now
  std::string data_;         ///< of that array, as sent
  bool resumed_ = false;     ///< the header is to come again
  std::uint32_t parts_ = 0;  ///< since the last header
  std::uint64_t part_bytes_ = 0;
  std::uint64_t received_ = 0;
  std::uint64_t expected_ = 0;
  std::set<remesh::v1::MeshArray> arrays_;  ///< that `mesh_` has
  Mesh mesh_;
};

}  // namespace remeshd::client
