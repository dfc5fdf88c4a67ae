#pragma once

#include <stdexcept>
#include <string>

#include "client/cli/documents.h"
#include "proto/document_error.h"
#include "remeshd/error.h"

namespace remeshd::cli {

/// An error in a document, with the file and, where it is known, its place there.
class InDocument : public std::runtime_error {
 public:
  InDocument(const std::string& file, remesh::v1::Error detail);
  [[nodiscard]] const remesh::v1::Error& detail() const { return detail_; }
  /// `hub.json:12:5`, or `hub.json` where no line is known.
  [[nodiscard]] std::string place() const;

 private:
  std::string file_;
  remesh::v1::Error detail_;
};

/// Throws the error of reading a document as InDocument, unless it could not be read at all: then
/// its message names the file.
[[noreturn]] void throw_in_document(const std::string& file, const DocumentError& error);
/// Likewise an error of the daemon about the model or the edit. The daemon does not know the file:
/// the place is looked for in its text here. Other errors are thrown as they are.
[[noreturn]] void throw_in_document(const Documents& documents, const std::string& file,
                                    const client::CallError& error);

/// Returns what `work` returns, which reads or sends the document of a file; its errors about the
/// document become InDocument.
template <typename Work>
auto in_document(Documents& documents, const std::string& file, Work&& work) {
  try {
    return work();
  } catch (const DocumentError& error) {
    throw_in_document(file, error);
  } catch (const client::CallError& error) {
    throw_in_document(documents, file, error);
  }
}

}  // namespace remeshd::cli
