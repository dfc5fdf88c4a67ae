#pragma once

#include <string_view>

#include "engine/base/error.h"

namespace remeshd {

/// Adds line and column to an error about a value that the text of a document has. Others, and
/// those that have a line, stay as they are.
void add_place(ErrorInfo& error, std::string_view document);

/// What `work` returns; its errors tell their place in the document. Empty: it came as a message.
template <typename Work>
auto located(std::string_view document, Work&& work) {
  try {
    return work();
  } catch (Error& failure) {
    add_place(failure.info(), document);
    throw;
  }
}

}  // namespace remeshd
