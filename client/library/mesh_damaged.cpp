// SPDX-License-Identifier: Apache-2.0
#include "client/library/mesh_damaged.h"

#include <string_view>

#include "remeshd/error.h"

namespace remeshd::client {

void mesh_damaged(const std::string& what) {
  remesh::v1::Error error;
  error.set_code(remesh::v1::Error::CODE_DATA_LOSS);
  error.set_reason(remesh::v1::Error::MESH_DAMAGED);
  error.set_stage("transfer");
  error.set_message("the mesh arrived damaged: " + what);
  error.set_hint("fetch it again, whole");
  throw CallError(std::move(error));
}

std::string name_of(remesh::v1::MeshArray array) {
  constexpr std::string_view kPrefix = "MESH_ARRAY_";
  const std::string name = remesh::v1::MeshArray_Name(array);
  if (name.empty()) return "array " + std::to_string(static_cast<int>(array));
  return name.starts_with(kPrefix) ? name.substr(kPrefix.size()) : name;
}

}  // namespace remeshd::client
