#pragma once

#include <string>
#include <variant>

#include "client/cli/documents.h"
#include "remesh/v1/remesh.pb.h"

namespace remeshd::cli {

/// How a document or a revision is named on the command line, resolved: a model or an edit that was
/// read from a file, or the name of a revision as the daemon takes it.
using Named = std::variant<std::string, remesh::v1::FeatureModel, remesh::v1::ModelEdit>;

/// A document where the name has a `/`, ends in `.json` or is `-`, else `design`, `design@N`, an id
/// or a unique prefix of 8: what a name means does not depend on the files that happen to be there.
///
/// Throws DocumentError.
Named resolve(Documents& documents, const std::string& name);

/// The model or edit in a file of any name, or in the standard input. Throws DocumentError.
std::variant<remesh::v1::FeatureModel, remesh::v1::ModelEdit> read_either(Documents& documents,
                                                                          const std::string& file);
/// Likewise a model. Throws DocumentError.
remesh::v1::FeatureModel read_model(Documents& documents, const std::string& file);
/// Likewise an edit. Throws DocumentError.
remesh::v1::ModelEdit read_edit(Documents& documents, const std::string& file);

/// Throws UsageError where both documents are to come from the standard input.
void check_one_stdin(const std::string& one, const std::string& other);

/// What an edit can be based on: a revision or a model.
using Base = std::variant<std::string, remesh::v1::FeatureModel>;
/// As `resolve`. Throws UsageError where the file is an edit.
Base resolve_base(Documents& documents, const std::string& name);

}  // namespace remeshd::cli
