#pragma once

#include "remesh/v1/remesh.pb.h"
#include "server/session/session.h"

namespace remeshd {

/// The session's values as messages.
remesh::v1::FeatureModel encode(const ModelSource& source);
remesh::v1::Report encode(const Report& report);
remesh::v1::RevisionInfo encode(const RevisionRecord& record, const PlaceRecord& place);
remesh::v1::RevisionReply encode(const Made& made, const std::string& request_id);
remesh::v1::RevisionDescription encode(const Description& description);
remesh::v1::RevisionDescription::Place encode(const PlaceRecord& place);
remesh::v1::DesignInfo encode(const DesignRecord& design);
remesh::v1::Comparison encode(const ModelComparison& comparison);
remesh::v1::ValidateReply encode(const Validated& validated);
remesh::v1::FeatureType encode(const FeatureTypeInfo& type);
remesh::v1::Progress encode(const Progress& progress);

}  // namespace remeshd
