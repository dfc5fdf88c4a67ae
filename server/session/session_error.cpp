#include "server/session/session_error.h"

#include <string>
#include <utility>

namespace remeshd::error {
namespace {

ErrorInfo request_info(ErrorKind kind, std::string reason, std::string message) {
  ErrorInfo info;
  info.kind = kind;
  info.reason = std::move(reason);
  info.message = std::move(message);
  info.stage = "request";
  return info;
}

std::string name(std::string_view text) {
  std::string out("`");
  out.append(text.substr(0, 160));
  out.push_back('`');
  return out;
}

}  // namespace

Error revision_not_found(std::string_view reference, std::string_view hint) {
  ErrorInfo info = request_info(ErrorKind::NotFound, "REVISION_NOT_FOUND",
                                "there is no revision " + name(reference));
  info.hint = hint;
  return Error(std::move(info));
}

Error revision_ambiguous(std::string_view prefix) {
  ErrorInfo info = request_info(ErrorKind::InvalidArgument, "REVISION_AMBIGUOUS",
                                "more than one revision's id begins with " + name(prefix));
  info.hint = "give more digits";
  return Error(std::move(info));
}

Error reference_missing(std::string_view field) {
  ErrorInfo info = request_info(ErrorKind::InvalidArgument, "REVISION_MISSING",
                                "the request names no revision in " + name(field));
  info.parameter = field;
  info.hint = "a design, design@number, an id, or at least 8 digits of one";
  return Error(std::move(info));
}

Error design_not_found(std::string_view design) {
  return Error(
      request_info(ErrorKind::NotFound, "DESIGN_NOT_FOUND", "there is no design " + name(design)));
}

Error revision_outdated(std::string_view id, std::uint32_t made_by, std::uint32_t today) {
  ErrorInfo info =
      request_info(ErrorKind::FailedPrecondition, "REVISION_OUTDATED",
                   "the mesh of revision " + std::string(id.substr(0, 12)) +
                       " is lost, and version " + std::to_string(made_by) +
                       " of the algorithm made it; this is version " + std::to_string(today));
  info.hint = "`remesh remake " + std::string(id.substr(0, 12)) +
              "` makes a new revision of what is known of it";
  return Error(std::move(info));
}

Error not_reproducible(std::string_view id) {
  ErrorInfo info = request_info(ErrorKind::DataLoss, "NOT_REPRODUCIBLE",
                                "the mesh of revision " + std::string(id.substr(0, 12)) +
                                    " is lost, and making it again gives another one");
  info.hint = "please report this, with `remesh recipe " + std::string(id.substr(0, 12)) + "`";
  return Error(std::move(info));
}

Error design_empty(std::string_view design) {
  return Error(request_info(ErrorKind::NotFound, "DESIGN_EMPTY",
                            "the design " + name(design) + " has no revisions left"));
}

Error design_name_invalid(std::string_view why) {
  ErrorInfo info = request_info(ErrorKind::InvalidArgument, "DESIGN_NAME_INVALID",
                                "the design's name " + std::string(why));
  info.parameter = "design";
  info.hint =
      "a design is named by at most 128 bytes without `@` and control characters; without "
      "a name of its own it takes the model's";
  return Error(std::move(info));
}

Error head_protected(std::string_view design, std::uint32_t number) {
  ErrorInfo info = request_info(
      ErrorKind::FailedPrecondition, "HEAD_PROTECTED",
      "revision " + std::to_string(number) + " is the head of the design " + name(design));
  info.hint = "allow it to delete a head, or make another revision the head first";
  return Error(std::move(info));
}

Error head_conflict(std::string_view design, std::string_view expected, std::string_view head) {
  ErrorInfo info = request_info(ErrorKind::Aborted, "HEAD_CONFLICT",
                                "the head of the design " + name(design) + " is not " +
                                    name(expected.substr(0, 12)) + " any more" +
                                    (head.empty() ? "" : ", but " + name(head.substr(0, 12))));
  info.hint = "look at what is there, then edit that";
  return Error(std::move(info));
}

Error field_missing(std::string_view field, std::string_view hint) {
  ErrorInfo info =
      request_info(ErrorKind::InvalidArgument, "MISSING_FIELD", "the request lacks " + name(field));
  info.parameter = field;
  info.hint = hint;
  return Error(std::move(info));
}

Error warning_is_error(const Warning& warning) {
  ErrorInfo info = request_info(ErrorKind::FailedPrecondition, "WARNING_IS_ERROR",
                                std::string(name_of(warning.code)) + ": " + warning.message);
  info.features = warning.features;
  info.place = warning.point;
  info.hint = "leave the code out of fail_on to get the revision all the same";
  info.warning = warning;
  return Error(std::move(info));
}

Error option_invalid(std::string_view option, std::string_view why) {
  ErrorInfo info = request_info(ErrorKind::InvalidArgument, "OPTIONS_INVALID",
                                "the option " + name(option) + " " + std::string(why));
  info.parameter = option;
  return Error(std::move(info));
}

Error side_invalid(std::string_view side, std::string_view why) {
  ErrorInfo info = request_info(ErrorKind::InvalidArgument, "SIDE_INVALID",
                                "the " + std::string(side) + " side " + std::string(why));
  info.parameter = side;
  return Error(std::move(info));
}

}  // namespace remeshd::error
