#pragma once

#include <string_view>

#include "engine/base/error.h"

/// What is wrong with size controls, groups and their selectors, in the stage `model`. `parameter`
/// spells the place: `sizes.holes.on`, `groups.load.on`.
namespace remeshd::error {

Error selector_invalid(std::string_view parameter, std::string_view selector, std::string_view why);
/// A size whose selector names neither a part of the model's boundary nor material.
Error selector_empty(std::string_view size);
Error duplicate_size(std::string_view size);
/// A group whose selector names neither a part of the model's boundary nor material.
Error empty_group(std::string_view group);
/// A group whose selector names a part of the boundary that is too small for the mesh's facets;
/// `area`: length squared.
Error group_without_facets(std::string_view group, double area);
Error duplicate_group(std::string_view group);
Error group_named_as_feature(std::string_view group);

// Edits; the caller adds the edit's index.

/// A size that an edit adds without `field`.
Error incomplete_size(std::string_view size, std::string_view field);
Error unknown_size(std::string_view size);
/// A group that an edit adds without a selector.
Error incomplete_group(std::string_view group);
Error unknown_group(std::string_view group);

// What a group's policy does not let an edit do: FailedPrecondition.

/// Exact areas, length squared; `most`: the change allowed, as a share of the area before.
Error area_changed(std::string_view group, double before, double now, double most);
Error group_emptied(std::string_view group);

}  // namespace remeshd::error
