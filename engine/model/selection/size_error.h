#pragma once

#include <string_view>

#include "engine/base/error.h"

/// What is wrong with size controls and their selectors, in the stage `model`. `parameter` spells
/// the place: `sizes.holes.on`.
namespace remeshd::error {

Error selector_invalid(std::string_view parameter, std::string_view selector, std::string_view why);
/// A size whose selector names no face of the model's boundary.
Error selector_empty(std::string_view size);
Error duplicate_size(std::string_view size);

// Edits; the caller adds the edit's index.

/// A size that an edit adds without `field`.
Error incomplete_size(std::string_view size, std::string_view field);
Error unknown_size(std::string_view size);

}  // namespace remeshd::error
