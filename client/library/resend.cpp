// SPDX-License-Identifier: Apache-2.0
#include "client/library/resend.h"

#include <string>

#include "client/library/routes.h"

namespace remeshd::client {
namespace {

/// Whether a reference always means the same revision: an id, a prefix of one or `design@number`.
bool names_one_revision(const std::string& reference) {
  return reference.find('@') != std::string::npos || !is_name(reference);
}

/// Whether an edit names no design and is to be in one all the same.
bool wants_a_design(const remesh::v1::EditRevisionRequest& edit) {
  return edit.design().empty() && (!edit.head().has_file() || edit.head().file());
}

}  // namespace

Resend how_to_resend(const remesh::v1::EditStreamRequest& request,
                     const remesh::v1::RevisionResult* last) {
  if (!request.has_edit()) return Resend::AsItIs;
  const auto& edit = request.edit();
  if (names_one_revision(edit.base())) return Resend::AsItIs;
  const std::string& design = edit.base().empty() ? edit.design() : edit.base();
  if (last != nullptr && (design.empty() || design == last->revision().design()))
    return Resend::OnLast;
  // Without a base and without a result before it, the daemon can only refuse it.
  return design.empty() ? Resend::AsItIs : Resend::Impossible;
}

remesh::v1::EditStreamRequest on_last(remesh::v1::EditStreamRequest request,
                                      const remesh::v1::RevisionResult& last) {
  auto& edit = *request.mutable_edit();
  if (wants_a_design(edit)) edit.set_design(last.revision().design());
  edit.set_base(last.head().empty() ? last.revision().id() : last.head());
  return request;
}

remesh::v1::EditStreamRequest in_design_of_last(remesh::v1::EditStreamRequest request,
                                                const remesh::v1::RevisionResult& last) {
  if (request.has_edit() && request.edit().base() == last.revision().id() &&
      wants_a_design(request.edit()))
    request.mutable_edit()->set_design(last.revision().design());
  return request;
}

}  // namespace remeshd::client
