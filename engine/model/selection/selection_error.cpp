#include "engine/model/selection/selection_error.h"

#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include "engine/base/text/clip.h"

namespace remeshd::error {
namespace {

Error selection_error(std::string reason, std::string parameter, std::string message,
                      std::string hint) {
  return Error({.kind = ErrorKind::InvalidArgument,
                .reason = std::move(reason),
                .message = std::move(message),
                .stage = "model",
                .parameter = std::move(parameter),
                .hint = std::move(hint)});
}

std::string place_of(std::string_view size) { return "sizes." + clip(size); }
std::string place_of_group(std::string_view group) { return "groups." + clip(group); }

Error policy_broken(std::string_view group, std::string_view field, std::string_view what) {
  Error broken = selection_error("POLICY_BROKEN", place_of_group(group) + std::string(field),
                                 "the group " + quoted(group) + " " + std::string(what),
                                 "change the edit, or the policy by setGroup in the same edit");
  broken.info().kind = ErrorKind::FailedPrecondition;
  return broken;
}

}  // namespace

Error selector_invalid(std::string_view parameter, std::string_view selector,
                       std::string_view why) {
  return selection_error(
      "SELECTOR_INVALID", std::string(parameter),
      "the selector " + quoted(selector) + " of " + std::string(parameter) + " " + std::string(why),
      "write names of faces or ids of features, with * for any characters, ? for any "
      "one, | between them, and behind & where of them: hole*.wall | plate.top & z > 10");
}

Error selector_empty(std::string_view size) {
  return selection_error(
      "SELECTOR_EMPTY", place_of(size) + ".on",
      "the size " + quoted(size) + " selects no face of the model's boundary, nor material",
      "mend the selector, or remove the size");
}

Error duplicate_size(std::string_view size) {
  return selection_error("DUPLICATE_NAME", place_of(size) + ".id",
                         "there is more than one size " + quoted(size),
                         "give every size an id of its own");
}

Error incomplete_size(std::string_view size, std::string_view field) {
  return selection_error("MISSING_FIELD", place_of(size) + "." + std::string(field),
                         "the new size " + quoted(size) + " lacks " + quoted(field),
                         "a size that the model does not have yet needs `on` or `in`, and `size`");
}

Error unknown_size(std::string_view size) {
  Error unknown =
      selection_error("UNKNOWN_SIZE", place_of(size), "the model has no size " + quoted(size),
                      "ids are case-sensitive");
  unknown.info().kind = ErrorKind::NotFound;
  return unknown;
}

Error empty_group(std::string_view group) {
  return selection_error(
      "SELECTOR_EMPTY", place_of_group(group) + ".on",
      "the group " + quoted(group) + " selects nothing of the model's boundary and no material",
      "mend the selector, or remove the group");
}

Error group_without_facets(std::string_view group, double area) {
  return selection_error("SELECTOR_EMPTY", place_of_group(group) + ".on",
                         "the group " + quoted(group) + " selects an area of " +
                             std::to_string(area) + " where no facet of the mesh has its centroid",
                         "ask for a smaller size there, or select more");
}

Error duplicate_group(std::string_view group) {
  return selection_error("DUPLICATE_NAME", place_of_group(group),
                         "there is more than one group " + quoted(group),
                         "give every group a name of its own");
}

Error group_named_as_feature(std::string_view group) {
  return selection_error("DUPLICATE_NAME", place_of_group(group),
                         "the group " + quoted(group) + " has the id of a feature",
                         "files name features and groups alike: rename the group");
}

Error incomplete_group(std::string_view group) {
  return selection_error("MISSING_FIELD", place_of_group(group) + ".on",
                         "the new group " + quoted(group) + " lacks 'on'",
                         "a group that the model does not have yet needs a selector");
}

Error unknown_group(std::string_view group) {
  Error unknown =
      selection_error("UNKNOWN_GROUP", place_of_group(group),
                      "the model has no group " + quoted(group), "names are case-sensitive");
  unknown.info().kind = ErrorKind::NotFound;
  return unknown;
}

Error area_changed(std::string_view group, double before, double now, double most) {
  std::array<char, 160> change{};
  std::snprintf(change.data(), change.size(),
                "would change its area from %.6g to %.6g; its policy lets it change by %.4g %%",
                before, now, 100 * most);
  return policy_broken(group, ".policy.maxAreaChange", change.data());
}

Error group_emptied(std::string_view group) {
  return policy_broken(group, ".policy.onEmptied", "would select nothing any more");
}

}  // namespace remeshd::error
