// SPDX-License-Identifier: Apache-2.0
#include "client/library/document_limit.h"

#include <string>

#include "proto/json_reader.h"
#include "remeshd/error.h"

namespace remeshd::client {
namespace {

void check_document(const std::string& text) {
  constexpr std::size_t kLimit = DocumentLimits{}.bytes;
  if (text.size() <= kLimit) return;
  remesh::v1::Error error;
  error.set_code(remesh::v1::Error::CODE_INVALID_ARGUMENT);
  error.set_reason(remesh::v1::Error::DOCUMENT_TOO_LARGE);
  error.set_stage("document");
  error.set_message("the document has " + std::to_string(text.size()) +
                    " bytes, more than the limit of " + std::to_string(kLimit));
  error.set_hint("a model document describes features, not a mesh; is this the right file?");
  throw CallError(std::move(error));
}

}  // namespace

void check_documents(const remesh::v1::CreateRevisionRequest& request) {
  check_document(request.document());
}

void check_documents(const remesh::v1::EditRevisionRequest& request) {
  check_document(request.document());
}

void check_documents(const remesh::v1::CompareRequest& request) {
  check_document(request.original().document());
  check_document(request.modified().document());
}

void check_documents(const remesh::v1::ValidateModelRequest& request) {
  check_document(request.document());
}

void check_documents(const remesh::v1::ValidateEditRequest& request) {
  check_document(request.base_document());
  check_document(request.document());
}

}  // namespace remeshd::client
