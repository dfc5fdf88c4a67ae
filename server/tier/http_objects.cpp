#include "server/tier/http_objects.h"

#include <curl/curl.h>

#include <new>
#include <utility>

#include "server/limits.h"
#include "server/tier/tier_error.h"

namespace remeshd {
namespace {

constexpr long kConnectMs = 500;
// A transfer that has fewer bytes a second for so many seconds has failed.
constexpr long kLeastSpeed = 1024, kLeastSpeedSeconds = 2;
constexpr long kTransferMs = 60'000;

enum Status : long { kOk = 200, kFirstRefusal = 300, kNotFound = 404 };

std::size_t append(char* data, std::size_t size, std::size_t count, void* to) {
  auto& body = *static_cast<std::string*>(to);
  if (body.size() + size * count > limits::kTierObjectBytes) return 0;  // curl fails then
  body.append(data, size * count);
  return size * count;
}

}  // namespace

/// One request after another, over a connection that stays open.
class HttpObjects::Transfer {
 public:
  explicit Transfer(const HttpAccess& access) : access_(access), curl_(curl_easy_init()) {
    if (curl_ == nullptr) throw std::bad_alloc();
    // No wait for a go-ahead before the body; and an object is no form.
    for (const char* header : {"Expect:", "Content-Type: application/octet-stream"})
      headers_ = curl_slist_append(headers_, header);
  }
  ~Transfer() {
    curl_slist_free_all(headers_);
    curl_easy_cleanup(curl_);
  }
  Transfer(const Transfer&) = delete;
  Transfer& operator=(const Transfer&) = delete;

  void begin(const std::string& key, long most_ms) {
    curl_easy_reset(curl_);
    body_.clear();
    set(CURLOPT_URL, (access_.url + "/" + key).c_str());
    set(CURLOPT_PROTOCOLS_STR, "http,https");
    set(CURLOPT_NOSIGNAL, 1L);
    set(CURLOPT_CONNECTTIMEOUT_MS, std::min(kConnectMs, most_ms));
    set(CURLOPT_TIMEOUT_MS, most_ms);
    set(CURLOPT_LOW_SPEED_LIMIT, kLeastSpeed);
    set(CURLOPT_LOW_SPEED_TIME, kLeastSpeedSeconds);
    set(CURLOPT_HTTPHEADER, headers_);
    set(CURLOPT_WRITEFUNCTION, &append);
    set(CURLOPT_WRITEDATA, &body_);
    if (access_.region.empty()) return;
    set(CURLOPT_AWS_SIGV4, ("aws:amz:" + access_.region + ":s3").c_str());
    set(CURLOPT_USERNAME, access_.access_key.c_str());
    set(CURLOPT_PASSWORD, access_.secret_key.c_str());
  }

  template <typename Value>
  void set(CURLoption option, Value value) {
    curl_easy_setopt(curl_, option, value);
  }

  /// The status, one of success or `kNotFound`. Throws Error(TIER_UNAVAILABLE).
  long finish() {
    const auto fail = [](const std::string& why) {
      return error::tier_unavailable(why, limits::kTierRest.count());
    };
    const CURLcode result = curl_easy_perform(curl_);
    if (result != CURLE_OK) throw fail(curl_easy_strerror(result));
    long status = 0;
    curl_easy_getinfo(curl_, CURLINFO_RESPONSE_CODE, &status);
    if (status != kNotFound && (status < kOk || status >= kFirstRefusal))
      throw fail("it answers with status " + std::to_string(status));
    return status;
  }

  std::string take_body() { return std::move(body_); }

 private:
  const HttpAccess& access_;
  CURL* const curl_;
  curl_slist* headers_ = nullptr;
  std::string body_;
};

/// A transfer of the idle ones, or a new one; idle again afterwards.
class HttpObjects::Borrowed {
 public:
  explicit Borrowed(HttpObjects& owner) : owner_(owner) {
    const std::scoped_lock lock(owner_.mutex_);
    if (owner_.idle_.empty()) {
      transfer_ = std::make_unique<Transfer>(owner_.access_);
    } else {
      transfer_ = std::move(owner_.idle_.back());
      owner_.idle_.pop_back();
    }
  }
  ~Borrowed() {
    const std::scoped_lock lock(owner_.mutex_);
    owner_.idle_.push_back(std::move(transfer_));
  }
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;
  Transfer* operator->() const { return transfer_.get(); }

 private:
  HttpObjects& owner_;
  TransferPtr transfer_;
};

HttpObjects::HttpObjects(HttpAccess access) : access_(std::move(access)) {
  static const CURLcode ready = curl_global_init(CURL_GLOBAL_DEFAULT);
  if (ready != CURLE_OK) throw std::bad_alloc();
}

HttpObjects::~HttpObjects() = default;

bool HttpObjects::has(const std::string& key, double within) {
  const Borrowed transfer(*this);
  transfer->begin(key, std::max(1L, static_cast<long>(within * 1e3)));
  transfer->set(CURLOPT_NOBODY, 1L);
  return transfer->finish() != kNotFound;
}

std::optional<std::string> HttpObjects::get(const std::string& key) {
  const Borrowed transfer(*this);
  transfer->begin(key, kTransferMs);
  if (transfer->finish() == kNotFound) return std::nullopt;
  return transfer->take_body();
}

void HttpObjects::put(const std::string& key, const std::string& bytes) {
  const Borrowed transfer(*this);
  transfer->begin(key, kTransferMs);
  // As a body that is there whole, of which curl can sign the digest.
  transfer->set(CURLOPT_CUSTOMREQUEST, "PUT");
  transfer->set(CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(bytes.size()));
  transfer->set(CURLOPT_POSTFIELDS, bytes.data());
  if (transfer->finish() == kNotFound)
    throw error::tier_unavailable("its folder or bucket is not there", limits::kTierRest.count());
}

}  // namespace remeshd
