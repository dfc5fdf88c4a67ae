// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <string_view>
#include <variant>

#include "proto/json_reader.h"
#include "remesh/v1/remesh.pb.h"

namespace remeshd {

/// The text of a document file. A file over the limit is not read at all.
///
/// Throws DocumentError: `DOCUMENT_TOO_LARGE`, `DOCUMENT_UNREADABLE`.
std::string read_document(const std::filesystem::path& file, const DocumentLimits& limits = {});
/// The same of a stream, to its end; `name` stands for it in errors.
std::string read_document(std::istream& in, const std::string& name,
                          const DocumentLimits& limits = {});

/// A model document, `{"name": ..., "features": [...]}`, as its message. Fields, their kinds and
/// the names of enumerators are checked here; values are looked at by the server, which checks them
/// for every message, whoever sent it. What document.proto says of documents holds: parameters stay
/// in the order written, in the short form or the long one; names in camelCase or snake_case.
///
/// Throws DocumentError, naming the feature by its id where it has one, line and column:
/// what `read_json` throws, `UNKNOWN_FIELD`, `DUPLICATE_KEY`, `MISSING_FIELD`, `WRONG_KIND`.
remesh::v1::FeatureModel parse_model(std::string_view text, const DocumentLimits& limits = {});

/// The same for an edit document, `{"edits": [...]}`; errors carry the index of the edit. Throws
/// `NO_EDITS` for an empty list too.
remesh::v1::ModelEdit parse_edit(std::string_view text, const DocumentLimits& limits = {});

/// Whichever of the two it is: an edit document is one with the field `edits`.
std::variant<remesh::v1::FeatureModel, remesh::v1::ModelEdit> parse_document(
    std::string_view text, const DocumentLimits& limits = {});

}  // namespace remeshd
