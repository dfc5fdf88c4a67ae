#include "server/service/request_id.h"

#include "engine/base/error.h"
#include "server/limits.h"
#include "server/service/fitting.h"

namespace remeshd {
void check_request_id(const std::string& id) {
  if (id.size() <= limits::kRequestIdBytes) return;
  ErrorInfo info;
  info.kind = ErrorKind::InvalidArgument;
  info.reason = "REQUEST_ID_TOO_LONG";
  info.message = "the request id has " + std::to_string(id.size()) + " bytes, more than " +
                 std::to_string(limits::kRequestIdBytes);
  info.stage = "request";
  info.parameter = "request_id";
  info.hint = "choose a shorter id";
  throw Error(std::move(info));
}

std::string echoed_request_id(const std::string& id) {
  return fitting(id, limits::kRequestIdBytes);
}

}  // namespace remeshd
