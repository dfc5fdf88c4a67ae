// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "remesh/v1/remesh.pb.h"

namespace remeshd::client {

// Throw CallError INVALID_ARGUMENT, DOCUMENT_TOO_LARGE for a request with a document of more than
// 4 MiB, which is then not sent.
void check_documents(const remesh::v1::CreateRevisionRequest& request);
void check_documents(const remesh::v1::EditRevisionRequest& request);
void check_documents(const remesh::v1::CompareRequest& request);
void check_documents(const remesh::v1::ValidateModelRequest& request);
void check_documents(const remesh::v1::ValidateEditRequest& request);

}  // namespace remeshd::client
