#pragma once

#include <string>
#include <variant>

#include "remesh/v1/remesh.pb.h"

namespace remeshd::cli {

/// How a document or a revision is named on the command line, resolved: a model or an edit that was
/// read from a file, or the name of a revision as the daemon takes it.
using Named = std::variant<std::string, remesh::v1::FeatureModel, remesh::v1::ModelEdit>;

/// A file where the name has a `/` or ends in `.json`, else `design`, `design@N`, an id or a unique
/// prefix of 8: what a name means does not depend on the files that happen to be there.
///
/// Throws DocumentError.
Named resolve(const std::string& name);

/// The model or edit in a file of any name. Throws DocumentError.
std::variant<remesh::v1::FeatureModel, remesh::v1::ModelEdit> read_either(const std::string& file);
/// The model in a file of any name. Throws DocumentError.
remesh::v1::FeatureModel read_model(const std::string& file);
/// The edit in a file of any name. Throws DocumentError.
remesh::v1::ModelEdit read_edit(const std::string& file);

/// What an edit can be based on: a revision or a model.
using Base = std::variant<std::string, remesh::v1::FeatureModel>;
/// As `resolve`. Throws UsageError where the file is an edit.
Base resolve_base(const std::string& name);

}  // namespace remeshd::cli
