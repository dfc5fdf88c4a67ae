// SPDX-License-Identifier: Apache-2.0
#include "client/library/status.h"

#include "remesh/v1/rpc_status.pb.h"

namespace remeshd::client {

std::string describe(const remesh::v1::Error& error) {
  std::string where;
  const auto add = [&](const std::string& what, const std::string& name) {
    // Most messages say themselves where they belong.
    if (name.empty() || error.message().find(name) != std::string::npos) return;
    if (!where.empty()) where += ", ";
    where += what + name;
  };
  const std::string edit = "edit " + std::to_string(error.edit_index());
  if (error.has_edit_index()) add("", edit);
  add("feature ", error.feature());
  add("parameter ", error.parameter());
  std::string text = where.empty() ? "" : where + ": ";
  text += error.message().empty() ? remesh::v1::Error::Code_Name(error.code()) : error.message();
  if (!error.hint().empty()) text += " (" + error.hint() + ")";
  return text;
}

CallError::CallError(remesh::v1::Error detail)
    : std::runtime_error(describe(detail)), detail_(std::move(detail)) {}

remesh::v1::Error error_of(const grpc::Status& status) {
  remesh::v1::RpcStatus rich;
  remesh::v1::Error error;
  if (rich.ParseFromString(status.error_details()))
    for (const google::protobuf::Any& detail : rich.details())
      if (detail.Is<remesh::v1::Error>() && detail.UnpackTo(&error)) return error;
  const int code = static_cast<int>(status.error_code());
  error.set_code(remesh::v1::Error::Code_IsValid(code) ? static_cast<remesh::v1::Error::Code>(code)
                                                       : remesh::v1::Error::UNKNOWN);
  error.set_message(status.error_message());
  return error;
}

void check(const grpc::Status& status) {
  if (!status.ok()) throw CallError(error_of(status));
}

}  // namespace remeshd::client
