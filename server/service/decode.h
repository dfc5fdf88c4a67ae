#pragma once

#include <string>
#include <variant>

#include "proto/document.h"
#include "remesh/v1/remesh.pb.h"
#include "server/service/decode_model.h"
#include "server/session/commands.h"

namespace remeshd {

/// Translates requests into the session's terms. A model or an edit may come as a message or as the
/// text of a document, which is read here; `limits` say how long it may be.
///
/// All throw Error(InvalidArgument) for what cannot be right.
OptionsPatch decode(const remesh::v1::MeshOptions& message);
std::vector<WarningCode> fail_on_of(const remesh::v1::MeshOptions& message);
HeadRule decode(const remesh::v1::HeadUpdate& message);
CreateCommand decode(const remesh::v1::CreateRevisionRequest& message,
                     const DocumentLimits& limits);
EditCommand decode(const remesh::v1::EditRevisionRequest& message, const DocumentLimits& limits);
ComparisonSide decode(const remesh::v1::ModelChoice& message, const char* side,
                      const DocumentLimits& limits);
ModelSource decode(const remesh::v1::ValidateModelRequest& message, const DocumentLimits& limits);

/// An edit and what it is for: a revision's name, or a model.
struct EditToValidate {
  std::variant<std::string, ModelSource> base;
  ModelEdit edit;
};
EditToValidate decode(const remesh::v1::ValidateEditRequest& message, const DocumentLimits& limits);

}  // namespace remeshd
