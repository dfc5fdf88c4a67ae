#include "server/service/located.h"

#include "proto/place_in_document.h"

namespace remeshd {

void add_place(ErrorInfo& error, std::string_view document) {
  const bool of_a_value = error.stage == "model" || error.stage == "document";
  if (document.empty() || error.line || !of_a_value) return;
  ValueAtFault what{.feature = {}, .parameter = error.parameter};
  if (!error.features.empty()) what.feature = error.features.front();
  if (error.edit_index) what.edit_index = static_cast<std::uint32_t>(*error.edit_index);
  const TextPosition at = place_in_document(document, what);
  if (at.line == 0) return;
  error.line = static_cast<int>(at.line);
  error.column = static_cast<int>(at.column);
}

}  // namespace remeshd
