#include "client/cli/in_document.h"

#include <utility>

#include "client/cli/exit_code.h"
#include "proto/place_in_document.h"

namespace remeshd::cli {
namespace {

/// Whether the error is about the text of the document, not about the mesh made from it.
bool is_of_document(const remesh::v1::Error& error) {
  return error.has_line() || error.stage() == "model" || error.stage() == "document";
}

TextPosition look_up(const std::string& text, const remesh::v1::Error& error) {
  if (error.has_line()) return {error.line(), error.column()};
  ValueAtFault what{.feature = {}, .parameter = error.parameter()};
  if (error.features_size() > 0) what.feature = error.features(0);
  if (error.has_edit_index()) what.edit_index = error.edit_index();
  return place_in_document(text, what);
}

}  // namespace

InDocument::InDocument(const std::string& file, remesh::v1::Error detail)
    : std::runtime_error(detail.message()), file_(file), detail_(std::move(detail)) {}

std::string InDocument::place() const {
  std::string text = Documents::shown(file_);
  if (!detail_.has_line()) return text;
  text += ":" + std::to_string(detail_.line());
  if (detail_.has_column()) text += ":" + std::to_string(detail_.column());
  return text;
}

void throw_in_document(const std::string& file, const DocumentError& error) {
  remesh::v1::Error detail = to_detail(error.info());
  if (detail.reason() == remesh::v1::Error::DOCUMENT_UNREADABLE) throw DocumentError(error);
  throw InDocument(file, std::move(detail));
}

void throw_in_document(const Documents& documents, const std::string& file,
                       const client::CallError& error) {
  // What was not read here is the name of a revision.
  const std::string* text = documents.find(file);
  if (text == nullptr || !is_of_document(error.detail())) throw client::CallError(error);
  remesh::v1::Error detail = error.detail();
  const TextPosition at = look_up(*text, detail);
  if (at.line > 0) {
    detail.set_line(at.line);
    detail.set_column(at.column);
  }
  throw InDocument(file, std::move(detail));
}

}  // namespace remeshd::cli
