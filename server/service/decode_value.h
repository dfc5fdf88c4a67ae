#pragma once

#include <google/protobuf/struct.pb.h>

#include <array>
#include <string>
#include <vector>

#include "engine/model/source.h"
#include "proto/document_error.h"

namespace remeshd {

/// Values in a message, which need not come from a document: no null, boolean, NaN or infinity,
/// lists and objects only where a profile has them, texts without NUL. All throw DocumentError.
const std::string& text_of(const std::string& text, const DocumentPlace& place);
Scalar scalar_of(const google::protobuf::Value& value, const DocumentPlace& place);
std::array<Scalar, 3> triple_of(
    const google::protobuf::RepeatedPtrField<google::protobuf::Value>& values,
    const DocumentPlace& place);
BallSource ball_of(const google::protobuf::ListValue& values, const DocumentPlace& place);
BoxSource box_of(const google::protobuf::ListValue& values, const DocumentPlace& place);
std::vector<ProfileEntry> profile_of(const google::protobuf::Value& value,
                                     const DocumentPlace& place);

/// The place of something inside `place`.
DocumentPlace below(DocumentPlace place, const std::string& path);
DocumentPlace entry(DocumentPlace place, int index);

}  // namespace remeshd
