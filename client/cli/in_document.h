#pragma once

#include <stdexcept>
#include <string>

#include "proto/document_error.h"
#include "remeshd/error.h"

namespace remeshd::cli {

/// An error with its place in a document that was read from a file.
class InDocument : public std::runtime_error {
 public:
  /// `detail` has a line.
  InDocument(const std::string& file, remesh::v1::Error detail);
  [[nodiscard]] const remesh::v1::Error& detail() const { return detail_; }
  /// `hub.json:12:5`.
  [[nodiscard]] std::string place() const;

 private:
  std::string file_;
  remesh::v1::Error detail_;
};

/// Throws the error of reading a file as InDocument where it has a line there, else as it is.
[[noreturn]] void throw_in_document(const std::string& file, const DocumentError& error);
/// Likewise an error of the daemon, which knows no file: its place is looked for there.
[[noreturn]] void throw_in_document(const std::string& file, const client::CallError& error);

/// What `work` returns, which reads or sends the document of a file.
template <typename Work>
auto in_document(const std::string& file, Work&& work) {
  try {
    return work();
  } catch (const DocumentError& error) {
    throw_in_document(file, error);
  } catch (const client::CallError& error) {
    throw_in_document(file, error);
  }
}

}  // namespace remeshd::cli
