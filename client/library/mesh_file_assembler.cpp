// SPDX-License-Identifier: Apache-2.0
#include "client/library/mesh_file_assembler.h"

#include "client/library/mesh_damaged.h"
#include "proto/checksum.h"

namespace remeshd::client {

void MeshFileAssembler::add(const remesh::v1::GetMeshFileResponse& message) {
  if (message.has_header()) {
    if (has_header_) mesh_damaged("a second header");
    has_header_ = true;
    header_ = message.header();
    return;
  }
  if (!message.has_part()) mesh_damaged("an empty message");
  if (!has_header_) mesh_damaged("a part comes before the header");
  const remesh::v1::MeshFilePart& part = message.part();
  if (part.offset() != file_.size()) mesh_damaged("the file has a gap");
  if (part.data().size() > header_.bytes() - file_.size())
    mesh_damaged("the file is longer than announced");
  if (crc32c(part.data()) != part.crc32c()) mesh_damaged("wrong CRC-32C in a part of the file");
  file_ += part.data();
}

std::string MeshFileAssembler::finish() {
  if (!has_header_ || file_.size() != header_.bytes()) mesh_damaged("the file is not complete");
  if (sha256_hex(file_) != header_.digest()) mesh_damaged("wrong digest of the file");
  return std::move(file_);
}

}  // namespace remeshd::client
