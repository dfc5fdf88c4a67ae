// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "proto/checksum.h"
#include "remesh/v1/remesh.pb.h"
#include "remeshd/mesh.h"

namespace remeshd::client {

/// Puts the messages of a GetMesh stream together and checks all of them.
///
/// Every function throws CallError(DATA_LOSS) where a checksum, an order, a length, a count or an
/// index is wrong.
class MeshAssembler {
 public:
  void add(const remesh::v1::MeshMessage& message);
  /// The mesh, once the end has come.
  [[nodiscard]] Mesh finish() const;

  [[nodiscard]] std::uint64_t bytes_received() const { return received_; }
  [[nodiscard]] std::uint64_t bytes_expected() const { return expected_; }

 private:
  void add_header(const remesh::v1::MeshHeader& header);
  void add_part(const remesh::v1::MeshPart& part);
  void add_end(const remesh::v1::MeshEnd& end);

  Sha256 sha256_;
  remesh::v1::MeshHeader header_;
  bool has_header_ = false;
  bool ended_ = false;
  int current_ = 0;  ///< place in the header of the array that comes now
  std::uint32_t parts_ = 0;
  std::uint64_t received_ = 0;
  std::uint64_t expected_ = 0;
  std::map<int, std::string> arrays_;
};

}  // namespace remeshd::client
