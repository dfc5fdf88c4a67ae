// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "proto/document_error.h"

namespace remeshd {

/// What an error about values is about, in the words of the protocol's Error.
struct ValueAtFault {
  std::string_view feature;    ///< id; empty outside of features
  std::string_view parameter;  ///< `radius`, `placement.origin[1]`, `profile[3]`; empty if none
  std::optional<std::uint32_t> edit_index{};
};

/// Where that stands in the text of a model or an edit: the value of the parameter or, where the
/// document has none, the feature or the edit. Of several edits that set it the last one counts.
/// Line 0 where the document has none of it, or is none.
TextPosition place_in_document(std::string_view text, const ValueAtFault& what);

}  // namespace remeshd
