#include "client/cli/base.h"

#include "client/cli/exit_code.h"
#include "client/cli/in_document.h"
#include "proto/document.h"

namespace remeshd::cli {
namespace {

bool is_file_name(const std::string& name) {
  return name.find('/') != std::string::npos || name.ends_with(".json");
}

}  // namespace

Named resolve(const std::string& name) {
  if (!is_file_name(name)) return name;
  auto document = read_either(name);
  if (auto* model = std::get_if<remesh::v1::FeatureModel>(&document)) return std::move(*model);
  return std::get<remesh::v1::ModelEdit>(std::move(document));
}

std::variant<remesh::v1::FeatureModel, remesh::v1::ModelEdit> read_either(const std::string& file) {
  return in_document(file, [&] { return parse_document(read_document(file)); });
}

remesh::v1::FeatureModel read_model(const std::string& file) {
  return in_document(file, [&] { return parse_model(read_document(file)); });
}

remesh::v1::ModelEdit read_edit(const std::string& file) {
  return in_document(file, [&] { return parse_edit(read_document(file)); });
}

Base resolve_base(const std::string& name) {
  Named named = resolve(name);
  if (auto* revision = std::get_if<std::string>(&named)) return std::move(*revision);
  if (auto* model = std::get_if<remesh::v1::FeatureModel>(&named)) return std::move(*model);
  throw UsageError(name + " is an edit; a revision or a model is needed here");
}

}  // namespace remeshd::cli
