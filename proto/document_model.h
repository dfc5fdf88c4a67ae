// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proto/document_entry.h"
#include "remesh/v1/document.pb.h"

namespace remeshd {

/// Parts of a document as their messages. Fields, their kinds and the names of enumerators are
/// checked; values are not. All throw DocumentError.
void read_model(const Entry& entry, remesh::v1::FeatureModel& out);
void read_feature(const Entry& entry, remesh::v1::Feature& out);
void read_placement(const Entry& entry, remesh::v1::Placement& out);
/// `id` must be there; what a model needs beside it may be left out in an edit.
void read_size(const Entry& entry, remesh::v1::SizeControl& out);
/// Selector and policy of a group, of which the name is read elsewhere.
void read_policy(const Entry& entry, remesh::v1::GroupPolicy& out);

}  // namespace remeshd
