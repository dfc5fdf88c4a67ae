#include "server/session/session_error.h"

#include <string>

namespace remeshd::error {
namespace {

std::string name(std::string_view text) {
  std::string out("`");
  out.append(text.substr(0, 160));
  out.push_back('`');
  return out;
}

}  // namespace

Error revision_not_found(std::string_view reference, std::string_view hint) {
  return Error({.kind = ErrorKind::NotFound,
                .reason = "REVISION_NOT_FOUND",
                .message = "there is no revision " + name(reference),
                .stage = "request",
                .hint = std::string(hint)});
}

Error revision_ambiguous(std::string_view prefix) {
  return Error({.kind = ErrorKind::InvalidArgument,
                .reason = "REVISION_AMBIGUOUS",
                .message = "more than one revision's id begins with " + name(prefix),
                .stage = "request",
                .hint = "give more digits"});
}

Error reference_missing(std::string_view field) {
  return Error({.kind = ErrorKind::InvalidArgument,
                .reason = "REVISION_MISSING",
                .message = "the request names no revision in " + name(field),
                .stage = "request",
                .parameter = std::string(field),
                .hint = "a design, design@number, an id, or at least 8 digits of one"});
}

Error design_not_found(std::string_view design) {
  return Error({.kind = ErrorKind::NotFound,
                .reason = "DESIGN_NOT_FOUND",
                .message = "there is no design " + name(design),
                .stage = "request"});
}

Error revision_outdated(std::string_view id, std::uint32_t made_by, std::uint32_t today) {
  return Error({.kind = ErrorKind::FailedPrecondition,
                .reason = "REVISION_OUTDATED",
                .message = "the mesh of revision " + std::string(id.substr(0, 12)) +
                           " is lost, and version " + std::to_string(made_by) +
                           " of the algorithm made it; this is version " + std::to_string(today),
                .stage = "request",
                .hint = "`remesh remake " + std::string(id.substr(0, 12)) +
                        "` makes a new revision of what is known of it"});
}

Error not_reproducible(std::string_view id) {
  return Error(
      {.kind = ErrorKind::DataLoss,
       .reason = "NOT_REPRODUCIBLE",
       .message = "the mesh of revision " + std::string(id.substr(0, 12)) +
                  " is lost, and making it again gives another one",
       .stage = "request",
       .hint = "please report this, with `remesh recipe " + std::string(id.substr(0, 12)) + "`"});
}

Error design_empty(std::string_view design) {
  return Error({.kind = ErrorKind::NotFound,
                .reason = "DESIGN_EMPTY",
                .message = "the design " + name(design) + " has no revisions left",
                .stage = "request"});
}

Error design_name_invalid(std::string_view why) {
  return Error(
      {.kind = ErrorKind::InvalidArgument,
       .reason = "DESIGN_NAME_INVALID",
       .message = "the design's name " + std::string(why),
       .stage = "request",
       .parameter = "design",
       .hint = "a design is named by at most 128 bytes without `@` and control characters; without "
               "a name of its own it takes the model's"});
}

Error head_protected(std::string_view design, std::uint32_t number) {
  return Error({.kind = ErrorKind::FailedPrecondition,
                .reason = "HEAD_PROTECTED",
                .message = "revision " + std::to_string(number) + " is the head of the design " +
                           name(design),
                .stage = "request",
                .hint = "allow it to delete a head (`remesh rm --allow-head`), or make another "
                        "revision the head first"});
}

Error head_conflict(std::string_view design, std::string_view expected, std::string_view head) {
  return Error({.kind = ErrorKind::Aborted,
                .reason = "HEAD_CONFLICT",
                .message = "the head of the design " + name(design) + " is not " +
                           name(expected.substr(0, 12)) + " any more" +
                           (head.empty() ? "" : ", but " + name(head.substr(0, 12))),
                .stage = "request",
                .hint = "look at what is there, then edit that"});
}

Error field_missing(std::string_view field, std::string_view hint) {
  return Error({.kind = ErrorKind::InvalidArgument,
                .reason = "MISSING_FIELD",
                .message = "the request lacks " + name(field),
                .stage = "request",
                .parameter = std::string(field),
                .hint = std::string(hint)});
}

Error warning_is_error(const Warning& warning) {
  return Error({.kind = ErrorKind::FailedPrecondition,
                .reason = "WARNING_IS_ERROR",
                .message = std::string(name_of(warning.code)) + ": " + warning.message,
                .stage = "request",
                .features = warning.features,
                .hint = "leave the code out of fail_on (`--fail-on`, `--strict`) to get the "
                        "revision all the same",
                .place = warning.point,
                .warning = warning});
}

Error option_invalid(std::string_view option, std::string_view why) {
  return Error({.kind = ErrorKind::InvalidArgument,
                .reason = "OPTIONS_INVALID",
                .message = "the option " + name(option) + " " + std::string(why),
                .stage = "request",
                .parameter = std::string(option)});
}

Error side_invalid(std::string_view side, std::string_view why) {
  return Error({.kind = ErrorKind::InvalidArgument,
                .reason = "SIDE_INVALID",
                .message = "the " + std::string(side) + " side " + std::string(why),
                .stage = "request",
                .parameter = std::string(side)});
}

}  // namespace remeshd::error
