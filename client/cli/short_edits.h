#pragma once

#include <google/protobuf/struct.pb.h>

#include <string>

#include "remesh/v1/remesh.pb.h"

namespace remeshd::cli {

/// Adds a change of a parameter of the model, or of one of a feature where the name is
/// `feature.parameter`.
void add_set_parameter(remesh::v1::ModelEdit& edit, const std::string& name,
                       google::protobuf::Value value);

/// The same from `name=value`. A value that is not a number is an expression. Throws UsageError
/// where name or value is missing.
void add_assignment(remesh::v1::ModelEdit& edit, const std::string& assignment);

}  // namespace remeshd::cli
