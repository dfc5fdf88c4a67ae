#pragma once

#include <google/protobuf/timestamp.pb.h>

#include <cstdint>
#include <string>

#include "remesh/v1/remesh.pb.h"
#include "server/service/encode_model.h"
#include "server/service/encode_report.h"
#include "server/session/session.h"

namespace remeshd {

/// Nanoseconds since 1970 as a time stamp.
void put_time(std::int64_t ns, google::protobuf::Timestamp& out);

/// The session's values as messages.
remesh::v1::RevisionInfo encode(const RevisionRecord& record, const PlaceRecord& place);
remesh::v1::RevisionResult encode(const Made& made, const std::string& request_id);
remesh::v1::MeshOptions encode(const MeshOptions& options);
/// The options as JSON in one line.
std::string in_one_line(const MeshOptions& options);
/// `documents`: model and edit as text too.
remesh::v1::GetRevisionResponse encode(const Description& description, bool documents);
remesh::v1::DesignPlace encode(const PlaceRecord& place);
remesh::v1::DesignInfo encode(const DesignRecord& design);
remesh::v1::Comparison encode(const ModelComparison& comparison);
remesh::v1::ModelCheck encode(const Validated& validated);
remesh::v1::FeatureType encode(const FeatureTypeInfo& type);
remesh::v1::Progress encode(const Progress& progress);

}  // namespace remeshd
