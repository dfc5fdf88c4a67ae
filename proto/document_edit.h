// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proto/document_entry.h"
#include "remesh/v1/document.pb.h"

namespace remeshd {

/// An edit document as its message, checked as `read_model` checks. Throws DocumentError, with the
/// index of the edit at fault.
void read_edits(const Entry& entry, remesh::v1::ModelEdit& out);

}  // namespace remeshd
