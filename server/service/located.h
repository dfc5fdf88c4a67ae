#pragma once

#include <string_view>

#include "engine/base/error.h"

namespace remeshd {

/// Adds line and column to an error about a value in the text of a document. Errors about anything
/// else, and those that have a line already, stay as they are.
void add_place(ErrorInfo& error, std::string_view document);

/// Returns what `work` returns, and adds the place in the document to errors that it throws. An
/// empty document stands for a request that came as a message: nothing is added.
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
