// SPDX-License-Identifier: Apache-2.0
#include "client/library/status.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <string_view>
#include <vector>

#include "remesh/v1/rpc_status.pb.h"

namespace remeshd::client {
namespace {

constexpr std::string_view kCodePrefix = "CODE_";

/// Nine digits: coordinates are for people to find a place by, not to compute with.
std::string short_number(double value) {
  char buffer[64];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 9).ptr;
  return {buffer, end};
}

std::string joined(const auto& items, const auto& text_of) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "" : ", ") + text_of(item);
  return text;
}

}  // namespace

std::string describe(const remesh::v1::Error& error) {
  std::string where;
  const auto said = [&](const std::string& text) {
    return error.message().find(text) != std::string::npos;
  };
  const auto add = [&](const std::string& text) {
    if (!text.empty()) where += (where.empty() ? "" : ", ") + text;
  };
  if (error.has_line() && !said("line " + std::to_string(error.line()))) {
    add("line " + std::to_string(error.line()));
    if (error.has_column()) add("column " + std::to_string(error.column()));
  }
  const std::string edit = "edit " + std::to_string(error.edit_index());
  if (error.has_edit_index() && !said(edit)) add(edit);
  std::vector<std::string> features;
  std::ranges::copy_if(error.features(), std::back_inserter(features), std::not_fn(said));
  if (!features.empty())
    add((features.size() == 1 ? "feature " : "features ") + joined(features, std::identity()));
  if (!error.parameter().empty() && !said(error.parameter())) add("parameter " + error.parameter());
  if (!error.home().empty() && !said(error.home())) add("daemon " + error.home());
  const std::string point = joined(error.point(), short_number);
  if (!point.empty() && !said(point)) add("at (" + point + ")");
  std::string text = where.empty() ? "" : where + ": ";
  text += error.message().empty() ? code_name(error.code()) : error.message();
  if (!error.hint().empty()) text += " (" + error.hint() + ")";
  return text;
}

std::string code_name(remesh::v1::Error::Code code) {
  const std::string name = remesh::v1::Error::Code_Name(code);
  return name.starts_with(kCodePrefix) ? name.substr(kCodePrefix.size()) : name;
}

std::string reason_name(const remesh::v1::Error& error) {
  const std::string name = remesh::v1::Error::Reason_Name(error.reason());
  const bool told = error.reason() != remesh::v1::Error::REASON_UNSPECIFIED && !name.empty();
  return told ? name : code_name(error.code());
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
                                                       : remesh::v1::Error::CODE_UNKNOWN);
  error.set_message(status.error_message());
  return error;
}

void check(const grpc::Status& status) {
  if (!status.ok()) throw CallError(error_of(status));
}

}  // namespace remeshd::client
