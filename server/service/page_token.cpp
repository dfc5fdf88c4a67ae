#include "server/service/page_token.h"

#include <charconv>
#include <string_view>
#include <utility>

#include "engine/base/error.h"
#include "proto/checksum.h"
#include "proto/json_writer.h"

namespace remeshd {
namespace {

Error invalid_token() {
  ErrorInfo info;
  info.kind = ErrorKind::InvalidArgument;
  info.reason = "PAGE_TOKEN_INVALID";
  info.message = "the page token is none of this list with this filter and order";
  info.stage = "request";
  info.parameter = "page_token";
  info.hint = "begin with the first page";
  return Error(std::move(info));
}

/// Takes the text before the next `.`, which is taken too.
std::string_view take_field(std::string_view& rest) {
  const std::size_t end = rest.find('.');
  if (end == std::string_view::npos) throw invalid_token();
  const std::string_view field = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return field;
}

template <typename Number>
Number take_number(std::string_view& rest) {
  const std::string_view field = take_field(rest);
  Number number = 0;
  const char* end = field.data() + field.size();
  const auto parsed = std::from_chars(field.data(), end, number);
  if (parsed.ec != std::errc{} || parsed.ptr != end) throw invalid_token();
  return number;
}

}  // namespace

ListIdentity::ListIdentity(const char* kind, const google::protobuf::Message& filter, int order,
                           bool descending) {
  const std::string text = std::string(kind) + ' ' + std::to_string(order) + ' ' +
                           (descending ? "1 " : "0 ") + write_json(filter);
  digest_ = sha256_hex(text).substr(0, 16);
}

std::string ListIdentity::token(std::int64_t value, const std::string& id, std::uint32_t number,
                                const std::string& name) const {
  return digest_ + '.' + std::to_string(value) + '.' + id + '.' + std::to_string(number) + '.' +
         name;
}

ListIdentity::Row ListIdentity::read(const std::string& token) const {
  std::string_view rest = token;
  if (take_field(rest) != digest_) throw invalid_token();
  Row row;
  row.value = take_number<std::int64_t>(rest);
  row.id = take_field(rest);
  row.number = take_number<std::uint32_t>(rest);
  row.name = rest;
  return row;
}

}  // namespace remeshd
