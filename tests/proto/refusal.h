#pragma once

#include <gtest/gtest.h>

#include <string>

#include "proto/document.h"
#include "proto/document_error.h"

namespace remeshd::test {

/// The error that a text is refused with; fails the test where it is taken.
template <typename Parse>
DocumentErrorInfo refusal(Parse parse) {
  try {
    parse();
  } catch (const DocumentError& error) {
    return error.info();
  }
  ADD_FAILURE() << "the text was taken";
  return {};
}
inline DocumentErrorInfo model_refusal(const std::string& text) {
  return refusal([&] { parse_model(text); });
}

/// A model of a hole with more members.
inline std::string with_feature(const std::string& members) {
  return R"({"features": [{"id": "hole1", "nature": "SUBTRACTIVE", "type": "cylinder")" +
         (members.empty() ? "" : ", " + members) + "}]}";
}

}  // namespace remeshd::test
