#include "server/tier/http_transfer.h"

#include <curl/curl.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <string_view>
#include <utility>

#include "proto/checksum.h"
#include "server/limits.h"
#include "server/tier/tier_error.h"

namespace remeshd {
namespace {

constexpr long kConnectMs = 500;
// A transfer that has fewer bytes a second for so many seconds has failed.
constexpr long kLeastSpeed = 1024, kLeastSpeedSeconds = 2;

enum Status : long { kOk = 200, kFirstRefusal = 300, kNotFound = 404, kTooLarge = 413 };

std::size_t append(char* data, std::size_t size, std::size_t count, void* to) {
  auto& body = *static_cast<std::string*>(to);
  if (body.size() + size * count > limits::kTierObjectBytes) return 0;  // curl fails then
  body.append(data, size * count);
  return size * count;
}

/// As CURLOPT_XFERINFOFUNCTION: anything but 0 ends the transfer.
int stopped(void* token, curl_off_t, curl_off_t, curl_off_t, curl_off_t) {
  return static_cast<const std::stop_token*>(token)->stop_requested() ? 1 : 0;
}

/// The error code in an S3 service's answer, such as `NoSuchKey`; empty where there is none.
std::string_view s3_code(std::string_view body) {
  constexpr std::string_view kBegin = "<Code>", kEnd = "</Code>";
  constexpr std::size_t kMost = 64;
  const std::size_t at = body.find(kBegin);
  if (at == std::string_view::npos) return {};
  const std::string_view code = body.substr(at + kBegin.size(), kMost);
  return code.substr(0, code.find(kEnd));
}

}  // namespace

HttpTransfer::HttpTransfer(const HttpAccess& access) : access_(access), curl_(curl_easy_init()) {
  if (curl_ == nullptr) throw std::bad_alloc();
}

HttpTransfer::~HttpTransfer() {
  curl_slist_free_all(headers_);
  curl_easy_cleanup(curl_);
}

template <typename Option, typename Value>
void HttpTransfer::set(Option option, Value value) {
  curl_easy_setopt(curl_, option, value);
}

void HttpTransfer::add_header(const char* line) {
  curl_slist* const longer = curl_slist_append(headers_, line);
  if (longer == nullptr) throw std::bad_alloc();
  headers_ = longer;
}

/// S3 asks for the digest of the body in a header of its own, which curl 7.88 does not send unless
/// it is given. The header `Expect:` without a value curl would sign but not send: here the wait
/// for a go-ahead is cut to 1 ms instead.
void HttpTransfer::sign(const std::string& body) {
  set(CURLOPT_EXPECT_100_TIMEOUT_MS, 1L);
  add_header(("x-amz-content-sha256: " + sha256_hex(body)).c_str());
  set(CURLOPT_AWS_SIGV4, ("aws:amz:" + access_.region + ":s3").c_str());
  set(CURLOPT_USERNAME, access_.access_key.c_str());
  set(CURLOPT_PASSWORD, access_.secret_key.c_str());
}

void HttpTransfer::begin(const Request& request) {
  const long most_ms = std::max(1L, std::lround(request.seconds * 1e3));
  curl_easy_reset(curl_);
  body_.clear();
  curl_slist_free_all(headers_);
  headers_ = nullptr;
  add_header("Content-Type: application/octet-stream");  // an object is no form
  set(CURLOPT_URL, request.url.c_str());
  set(CURLOPT_PROTOCOLS_STR, "http,https");
  set(CURLOPT_NOSIGNAL, 1L);
  set(CURLOPT_CONNECTTIMEOUT_MS, std::min(kConnectMs, most_ms));
  set(CURLOPT_TIMEOUT_MS, most_ms);
  set(CURLOPT_LOW_SPEED_LIMIT, kLeastSpeed);
  set(CURLOPT_LOW_SPEED_TIME, kLeastSpeedSeconds);
  set(CURLOPT_WRITEFUNCTION, &append);
  set(CURLOPT_WRITEDATA, &body_);
  set(CURLOPT_NOPROGRESS, 0L);
  set(CURLOPT_XFERINFOFUNCTION, &stopped);
  set(CURLOPT_XFERINFODATA, &request.stop);
  if (access_.region.empty()) {
    add_header("Expect:");  // no wait for a go-ahead before the body
  } else {
    sign(request.body != nullptr ? *request.body : "");
  }
  set(CURLOPT_HTTPHEADER, headers_);
  if (request.most > 0) set(CURLOPT_RANGE, ("0-" + std::to_string(request.most - 1)).c_str());
  if (request.method == Method::Head) set(CURLOPT_NOBODY, 1L);
  if (request.method == Method::Delete) set(CURLOPT_CUSTOMREQUEST, "DELETE");
  if (request.method == Method::Put) {
    // The body as one buffer, which curl can send again where the server has closed the connection.
    set(CURLOPT_CUSTOMREQUEST, "PUT");
    set(CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(request.body->size()));
    set(CURLOPT_POSTFIELDS, request.body->data());
  }
}

HttpTransfer::Answer HttpTransfer::ask(const Request& request) {
  begin(request);
  const auto fail = [](const std::string& why) {
    return error::tier_unavailable(why, limits::kTierRest.count());
  };
  const CURLcode result = curl_easy_perform(curl_);
  if (result == CURLE_ABORTED_BY_CALLBACK) throw error::cancelled();
  if (result == CURLE_OPERATION_TIMEDOUT)
    throw error::tier_timed_out(curl_easy_strerror(result), limits::kTierRest.count());
  if (result != CURLE_OK) throw fail(curl_easy_strerror(result));
  long status = 0;
  curl_easy_getinfo(curl_, CURLINFO_RESPONSE_CODE, &status);
  const std::string code(status < kFirstRefusal ? "" : s3_code(body_));
  if (status == kTooLarge || code == "EntityTooLarge")
    throw error::tier_refused(request.body != nullptr ? request.body->size() : 0, status);
  if (status == kNotFound ? code == "NoSuchBucket" : status < kOk || status >= kFirstRefusal)
    throw fail("it answers with status " + std::to_string(status) +
               (code.empty() ? "" : " (" + code + ")"));
  return {.found = status != kNotFound, .body = std::move(body_)};
}

}  // namespace remeshd
