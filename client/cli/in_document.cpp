#include "client/cli/in_document.h"

#include <utility>

#include "client/cli/exit_code.h"
#include "proto/document.h"
#include "proto/place_in_document.h"

namespace remeshd::cli {
namespace {

TextPosition look_up(const std::string& file, const remesh::v1::Error& error) {
  if (error.has_line()) return {error.line(), error.column()};
  if (error.stage() != "model" && error.stage() != "document") return {};
  ValueAtFault what{.feature = {}, .parameter = error.parameter()};
  if (error.features_size() > 0) what.feature = error.features(0);
  if (error.has_edit_index()) what.edit_index = error.edit_index();
  try {
    return place_in_document(read_document(file), what);
  } catch (const DocumentError&) {  // no file, or not any more
    return {};
  }
}

}  // namespace

InDocument::InDocument(const std::string& file, remesh::v1::Error detail)
    : std::runtime_error(detail.message()), file_(file), detail_(std::move(detail)) {}

std::string InDocument::place() const {
  std::string text = file_ + ":" + std::to_string(detail_.line());
  if (detail_.has_column()) text += ":" + std::to_string(detail_.column());
  return text;
}

void throw_in_document(const std::string& file, const DocumentError& error) {
  if (error.info().at.line == 0) throw DocumentError(error);
  throw InDocument(file, to_detail(error.info()));
}

void throw_in_document(const std::string& file, const client::CallError& error) {
  const TextPosition at = look_up(file, error.detail());
  if (at.line == 0) throw client::CallError(error);
  remesh::v1::Error detail = error.detail();
  detail.set_line(at.line);
  detail.set_column(at.column);
  throw InDocument(file, std::move(detail));
}

}  // namespace remeshd::cli
