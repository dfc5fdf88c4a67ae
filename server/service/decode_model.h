#pragma once

#include "engine/base/error.h"
#include "engine/model/source.h"
#include "proto/document_error.h"
#include "remesh/v1/document.pb.h"

namespace remeshd {

/// What is wrong with a document, as an Error of the server: InvalidArgument, stage `document`.
Error to_error(const DocumentErrorInfo& info);

/// What `read` returns; a DocumentError comes out as an Error.
template <typename Read>
auto checked(Read&& read) {
  try {
    return read();
  } catch (const DocumentError& failure) {
    throw to_error(failure.info());
  }
}

/// Models and edits as the engine understands them. Every value is looked at, since a message on
/// the wire need not come from a document: known enumerators, no parameter twice, and what
/// decode_value.h says of values.
///
/// Both throw Error(InvalidArgument), stage `document`, with feature, parameter and edit index set.
ModelSource decode(const remesh::v1::FeatureModel& message);
ModelEdit decode(const remesh::v1::ModelEdit& message);

}  // namespace remeshd
