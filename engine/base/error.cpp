#include "engine/base/error.h"

#include <array>
#include <charconv>

#include "engine/base/run.h"
#include "engine/base/text/clip.h"

namespace remeshd::error {
namespace {

/// By default the fewest digits that read back to the same double, whatever the locale.
template <class... Format>
std::string number(double value, Format... format) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.begin(), digits.end(), value, format...).ptr;
  return {digits.begin(), end};
}

/// A count without decimals; three digits where it is too large to be read.
std::string whole_number(double value) {
  return value < 1e9 ? number(value, std::chars_format::fixed, 0)
                     : number(value, std::chars_format::general, 3);
}

/// Nine digits: a place is there to be looked for, not to be computed with.
std::string at(const Vec3& p) {
  std::string text = " at (";
  const char* separator = "";
  for (const double c : {p.x, p.y, p.z}) {
    text += separator + number(c, std::chars_format::general, 9);
    separator = ", ";
  }
  return text + ")";
}

/// The ids, clipped, without empty ones.
FeatureIds listed(const FeatureIds& features) {
  FeatureIds clipped;
  for (const std::string& id : features)
    if (!id.empty()) clipped.push_back(clip(id));
  return clipped;
}

std::string where(std::string_view feature, std::string_view parameter) {
  if (feature.empty()) return "parameter " + quoted(parameter);
  if (parameter.empty()) return "feature " + quoted(feature);
  return clip(parameter) + " of feature " + quoted(feature);
}

Error model_error(std::string reason, std::string_view feature, std::string_view parameter,
                  std::string message, std::string hint) {
  return Error({.kind = ErrorKind::InvalidArgument,
                .reason = std::move(reason),
                .message = std::move(message),
                .stage = "model",
                .features = listed({std::string(feature)}),
                .parameter = clip(parameter),
                .hint = std::move(hint)});
}

constexpr const char* kNearlyCoincide =
    "features that nearly coincide are the usual cause: let them coincide, or keep them further "
    "apart";

/// The Error for a sound model that cannot be meshed.
Error refused(std::string reason, std::string stage, std::string message, std::string hint,
              const std::optional<Vec3>& place = {}, const FeatureIds& features = {}) {
  return Error({.kind = ErrorKind::FailedPrecondition,
                .reason = std::move(reason),
                .message = std::move(message),
                .stage = std::move(stage),
                .features = listed(features),
                .hint = std::move(hint),
                .place = place});
}

}  // namespace

Error cancelled() {
  return Error({.kind = ErrorKind::Cancelled,
                .reason = "CANCELLED",
                .message = "the call was cancelled",
                .stage = "request"});
}

Error internal(std::string_view stage, std::string_view what) {
  return Error({.kind = ErrorKind::Internal,
                .reason = "INTERNAL",
                .message = std::string(what),
                .stage = std::string(stage)});
}

Error invalid_name(std::string_view feature, std::string_view parameter, std::string_view name,
                   std::string_view why) {
  return model_error(
      "INVALID_NAME", feature, parameter, "the name " + quoted(name) + " " + std::string(why),
      "names are a letter or underscore, then letters, digits and underscores, 64 at "
      "most, and neither pi, deg nor the name of a function");
}

Error duplicate_feature(std::string_view feature) {
  return model_error("DUPLICATE_FEATURE", feature, "",
                     "there is more than one feature " + quoted(feature),
                     "give every feature an id of its own");
}

Error duplicate_parameter(std::string_view parameter) {
  return model_error("DUPLICATE_PARAMETER", "", parameter,
                     "there is more than one parameter " + quoted(parameter),
                     "give every parameter a name of its own");
}

Error unknown_feature_type(std::string_view feature, std::string_view type,
                           std::string_view known_types) {
  return model_error("UNKNOWN_FEATURE_TYPE", feature, "type",
                     "feature " + quoted(feature) + " has the unknown type " + quoted(type),
                     "types are " + std::string(known_types));
}

Error missing_parameter(std::string_view feature, std::string_view parameter,
                        std::string_view type) {
  return model_error("MISSING_PARAMETER", feature, parameter,
                     where(feature, parameter) + " is missing",
                     "a " + clip(type) + " cannot be built without " + clip(parameter));
}

Error unknown_parameter(std::string_view feature, std::string_view parameter,
                        std::string_view known_parameters) {
  return model_error("UNKNOWN_PARAMETER", feature, parameter,
                     "feature " + quoted(feature) + " has no parameter " + quoted(parameter),
                     "its parameters are " + std::string(known_parameters));
}

Error wrong_value_kind(std::string_view feature, std::string_view parameter,
                       std::string_view expected) {
  return model_error("WRONG_VALUE_KIND", feature, parameter,
                     where(feature, parameter) + " must be " + std::string(expected), "");
}

Error non_finite_value(std::string_view feature, std::string_view parameter,
                       std::string_view value) {
  return model_error("NON_FINITE_VALUE", feature, parameter,
                     where(feature, parameter) + " is not a finite number: " + clip(value),
                     "look for a division by zero, a root or logarithm of a negative number, or an "
                     "overflow");
}

Error value_out_of_range(std::string_view feature, std::string_view parameter, double value,
                         std::string_view range) {
  return model_error("VALUE_OUT_OF_RANGE", feature, parameter,
                     where(feature, parameter) + " is " + number(value) + ", out of range",
                     "it must be " + std::string(range));
}

Error out_of_bounds(std::string_view parameter, double value, const std::optional<double>& lower,
                    const std::optional<double>& upper) {
  const std::string range = lower && upper ? "between " + number(*lower) + " and " + number(*upper)
                                           : (lower ? "at least " + number(*lower)
                                                    : "at most " + number(upper.value_or(0)));
  return model_error("VALUE_OUT_OF_RANGE", "", parameter,
                     where("", parameter) + " is " + number(value) + ", but must be " + range,
                     "its bounds are part of the model");
}

Error not_whole(std::string_view parameter, double value) {
  return model_error("VALUE_OUT_OF_RANGE", "", parameter,
                     where("", parameter) + " is " + number(value) + ", but must be a whole number",
                     "the model declares it an integer");
}

Error bounds_invalid(std::string_view parameter, std::string_view why) {
  return model_error("BOUNDS_INVALID", "", parameter,
                     "the bounds of " + where("", parameter) + " " + std::string(why),
                     "give lower <= upper, both finite, or leave one out");
}

Error degenerate_feature(std::string_view feature, std::string_view parameter, double value,
                         std::string_view why) {
  return model_error(
      "DEGENERATE_FEATURE", feature, parameter,
      where(feature, parameter) + " is " + number(value) + ": it " + std::string(why),
      "change " + clip(parameter) + " so that the feature has a volume");
}

Error degenerate_frame(std::string_view feature, std::string_view parameter, std::string_view why) {
  return model_error("DEGENERATE_FRAME", feature, parameter,
                     where(feature, parameter) + " " + std::string(why),
                     "give two directions that are neither zero nor parallel, or leave xAxis out");
}

Error invalid_profile(std::string_view feature, std::string_view parameter, std::string_view why,
                      std::string_view hint) {
  return model_error("INVALID_PROFILE", feature, parameter,
                     where(feature, parameter) + " " + std::string(why), std::string(hint));
}

Error self_intersecting_profile(std::string_view feature, std::string_view parameter,
                                std::string_view why) {
  return model_error("SELF_INTERSECTING_PROFILE", feature, parameter,
                     where(feature, parameter) + ": " + std::string(why),
                     "the sides of a profile may meet only at their common ends");
}

Error profile_crosses_axis(std::string_view feature, std::string_view parameter,
                           std::string_view why) {
  return model_error("PROFILE_CROSSES_AXIS", feature, parameter,
                     where(feature, parameter) + " " + std::string(why),
                     "keep the profile at x >= 0 and let it meet the axis in whole sides");
}

Error invalid_expression(std::string_view feature, std::string_view parameter,
                         std::string_view expression, std::string_view why) {
  return model_error("INVALID_EXPRESSION", feature, parameter,
                     where(feature, parameter) + ": cannot evaluate " + quoted(expression),
                     clip(why, 300));
}

Error unknown_name(std::string_view feature, std::string_view parameter, std::string_view name,
                   std::string_view expression) {
  return model_error("UNKNOWN_NAME", feature, parameter,
                     where(feature, parameter) + ": the expression " + quoted(expression) +
                         " uses the unknown name " + quoted(name),
                     "define it under the model's parameters; names are case-sensitive");
}

Error cyclic_parameters(std::string_view parameter, std::string_view cycle) {
  return model_error("CYCLIC_PARAMETERS", "", parameter,
                     "the parameters depend on each other in a circle: " + clip(cycle, 400),
                     "give one of them a number");
}

Error limit_exceeded(std::string_view feature, std::string_view parameter, std::string_view what,
                     std::size_t count, std::size_t limit) {
  return model_error("LIMIT_EXCEEDED", feature, parameter,
                     std::to_string(count) + " " + std::string(what) + " are too many",
                     "at most " + std::to_string(limit) + " are accepted");
}

Error no_features() {
  return model_error("NO_FEATURES", "", "", "the model has no features", "add an additive feature");
}

Error no_additive_feature() {
  return model_error("NO_ADDITIVE_FEATURE", "", "",
                     "every feature of the model is subtractive, so it has no material",
                     "add an additive feature");
}

Error unknown_feature(std::string_view feature) {
  Error unknown =
      model_error("UNKNOWN_FEATURE", feature, "", "the model has no feature " + quoted(feature),
                  "ids are case-sensitive");
  unknown.info().kind = ErrorKind::NotFound;
  return unknown;
}

Error unknown_model_parameter(std::string_view name) {
  return model_error("UNKNOWN_PARAMETER", "", name, "the model has no parameter " + quoted(name),
                     "an edit sets parameters that the model has; it adds none");
}

Error empty_model() {
  return refused("EMPTY_MODEL", "cells", "the model holds no material: every cell is subtracted",
                 "add a feature, or move one in history after those that remove it");
}

Error disconnected_model(int pieces, const Vec3& place, const FeatureIds& features) {
  return refused(
      "DISCONNECTED_MODEL", "cells",
      "the model falls into " + std::to_string(pieces) + " pieces that share no face, one of them" +
          at(place),
      "let the pieces overlap or touch along a face, or mesh them as models of their own", place,
      features);
}

Error non_manifold_model(std::string_view what, const Vec3& place, const FeatureIds& features) {
  return refused("NON_MANIFOLD_MODEL", "cells",
                 "the boundary touches itself " + std::string(what) + at(place),
                 "move one of the features that meet there a little", place, features);
}

Error kernel_failure(std::string_view what, const std::optional<Vec3>& place,
                     const FeatureIds& features) {
  return refused("KERNEL_FAILURE", "cells",
                 "the CAD kernel failed: " + clip(what, 400) + (place ? at(*place) : ""),
                 kNearlyCoincide, place, features);
}

Error tetgen_refused(std::string_view why) {
  return refused("TETGEN_REFUSED", "control mesh",
                 "TetGen refuses the model's surface: " + std::string(why), kNearlyCoincide);
}

Error surface_too_fine(std::size_t facets) {
  return refused(
      "TETGEN_REFUSED", "surface mesh",
      "the surface mesh for TetGen would need more than " + std::to_string(facets) + " facets",
      "ask for longer edges");
}

Error tetgen_crashed(std::string_view how) {
  return refused("TETGEN_CRASHED", "control mesh",
                 "TetGen failed on the model's surface: " + std::string(how),
                 "change a size or a place of the model a little");
}

Error tetgen_too_slow(double seconds) {
  return refused("TETGEN_TOO_SLOW", "control mesh",
                 "TetGen gave no answer within " + number(seconds) + " s",
                 "a simpler model, or a less busy machine");
}

Error tetgen_out_of_memory(std::size_t bytes) {
  return refused("TETGEN_OUT_OF_MEMORY", "control mesh",
                 "TetGen needs more than its " + std::to_string(bytes >> 20) + " MiB",
                 "a simpler model");
}

Error tetgen_missing(std::string_view path, std::string_view why) {
  return Error({.kind = ErrorKind::Internal,
                .reason = "TETGEN_MISSING",
                .message = clip(path, 200) + " does not start: " + std::string(why),
                .stage = "control mesh",
                .hint = "install remeshd-tetgen beside the program or in ../libexec/remeshd, or "
                        "name it in REMESHD_TETGEN"});
}

Error options_invalid(std::string_view option, std::string_view why) {
  return Error({.kind = ErrorKind::InvalidArgument,
                .reason = "OPTIONS_INVALID",
                .message = "option " + std::string(option) + ": " + std::string(why),
                .stage = "request",
                .parameter = std::string(option)});
}

Error mesh_too_large(std::string_view what, double nodes, std::uint32_t limit,
                     std::string_view option, std::string_view feature, std::string_view hint) {
  // The greatest limit that a daemon takes is the default.
  const char* larger =
      limit < kDefaultMaxNodes ? ", or start remeshd with a larger --max-nodes" : "";
  return Error({.kind = ErrorKind::InvalidArgument,
                .reason = "MESH_TOO_LARGE",
                .message = std::string(what) + " " + whole_number(nodes) +
                           " nodes, more than the limit of " + std::to_string(limit),
                .stage = "request",
                .features = listed({std::string(feature)}),
                .parameter = std::string(option),
                .hint = std::string(hint) + larger});
}

Error boundary_not_recovered(std::string_view what, const std::optional<Vec3>& place,
                             const FeatureIds& features) {
  return refused("BOUNDARY_NOT_RECOVERED", "verify",
                 "no valid mesh could be made: " + std::string(what),
                 "ask for more nodes or a smaller edge length, or make what is thin or small at "
                 "that place larger",
                 place, features);
}

}  // namespace remeshd::error
