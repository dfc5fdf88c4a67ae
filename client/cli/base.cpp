#include "client/cli/base.h"

#include "client/cli/exit_code.h"
#include "client/cli/in_document.h"
#include "proto/document.h"

namespace remeshd::cli {
namespace {

bool is_file_name(const std::string& name) {
  return name.find('/') != std::string::npos || name.ends_with(".json") || name == kStandardStream;
}

}  // namespace

Named resolve(Documents& documents, const std::string& name) {
  if (!is_file_name(name)) return name;
  auto document = read_either(documents, name);
  if (auto* model = std::get_if<remesh::v1::FeatureModel>(&document)) return std::move(*model);
  return std::get<remesh::v1::ModelEdit>(std::move(document));
}

std::variant<remesh::v1::FeatureModel, remesh::v1::ModelEdit> read_either(Documents& documents,
                                                                          const std::string& file) {
  return in_document(documents, file, [&] { return parse_document(documents.text(file)); });
}

remesh::v1::FeatureModel read_model(Documents& documents, const std::string& file) {
  return in_document(documents, file, [&] { return parse_model(documents.text(file)); });
}

remesh::v1::ModelEdit read_edit(Documents& documents, const std::string& file) {
  return in_document(documents, file, [&] { return parse_edit(documents.text(file)); });
}

void check_one_stdin(const std::string& one, const std::string& other) {
  if (one == kStandardStream && other == kStandardStream)
    throw UsageError("only one document can be `-`: the standard input is read once");
}

Base resolve_base(Documents& documents, const std::string& name) {
  Named named = resolve(documents, name);
  if (auto* revision = std::get_if<std::string>(&named)) return std::move(*revision);
  if (auto* model = std::get_if<remesh::v1::FeatureModel>(&named)) return std::move(*model);
  throw UsageError(Documents::shown(name) + " is an edit; a revision or a model is needed here");
}

}  // namespace remeshd::cli
