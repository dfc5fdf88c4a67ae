#pragma once

#include "remesh/v1/remesh.pb.h"
#include "server/session/commands.h"

namespace remeshd {

/// Messages as the session understands them. Every value is looked at, since a message on the wire
/// need not come from a document: no null, boolean, NaN or infinity, lists and objects only where a
/// profile has them, known enumerators, names and strings without NUL.
///
/// All throw Error(InvalidArgument), stage `document`, with feature, parameter and edit index set.
ModelSource decode(const remesh::v1::FeatureModel& message);
ModelEdit decode(const remesh::v1::ModelEdit& message);
OptionsPatch decode(const remesh::v1::MeshOptions& message);
HeadRule decode(const remesh::v1::HeadUpdate& message);
CreateCommand decode(const remesh::v1::CreateRevisionRequest& message);
EditCommand decode(const remesh::v1::EditRevisionRequest& message);
ComparisonSide decode(const remesh::v1::ModelChoice& message, const char* side);

}  // namespace remeshd
