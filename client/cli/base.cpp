#include "client/cli/base.h"

#include <filesystem>

#include "client/cli/exit_code.h"
#include "proto/document.h"
#include "proto/document_error.h"

namespace remeshd::cli {
namespace {

bool can_only_be_a_file(const std::string& name) {
  return name.find('/') != std::string::npos || name.ends_with(".json");
}

}  // namespace

Named resolve(const std::string& name) {
  std::error_code ignored;
  const auto status = std::filesystem::status(name, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_directory(status)) {
    auto document = parse_document(read_document(name));
    if (auto* model = std::get_if<remesh::v1::FeatureModel>(&document)) return std::move(*model);
    return std::get<remesh::v1::ModelEdit>(std::move(document));
  }
  if (can_only_be_a_file(name)) throw error::document_unreadable(name, "no such file");
  return name;
}

remesh::v1::FeatureModel read_model(const std::string& file) {
  return parse_model(read_document(file));
}

remesh::v1::ModelEdit read_edit(const std::string& file) { return parse_edit(read_document(file)); }

Base resolve_base(const std::string& name) {
  Named named = resolve(name);
  if (auto* revision = std::get_if<std::string>(&named)) return std::move(*revision);
  if (auto* model = std::get_if<remesh::v1::FeatureModel>(&named)) return std::move(*model);
  throw UsageError(name + " is an edit; a revision or a model is needed here");
}

}  // namespace remeshd::cli
