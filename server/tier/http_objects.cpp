#include "server/tier/http_objects.h"

#include <curl/curl.h>

#include <new>
#include <utility>

#include "server/limits.h"
#include "server/tier/http_listing.h"
#include "server/tier/http_transfer.h"
#include "server/tier/tier_error.h"

namespace remeshd {
namespace {

using Method = HttpTransfer::Method;

}  // namespace

/// Borrows an idle transfer, or a new one, and returns it to the idle ones.
class HttpObjects::Borrowed {
 public:
  explicit Borrowed(HttpObjects& owner) : owner_(owner) {
    const std::scoped_lock lock(owner_.mutex_);
    if (owner_.idle_.empty()) {
      transfer_ = std::make_unique<HttpTransfer>(owner_.access_);
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
  HttpTransfer* operator->() const { return transfer_.get(); }

 private:
  HttpObjects& owner_;
  std::unique_ptr<HttpTransfer> transfer_;
};

HttpObjects::HttpObjects(HttpAccess access) : access_(std::move(access)) {
  static const CURLcode ready = curl_global_init(CURL_GLOBAL_DEFAULT);
  if (ready != CURLE_OK) throw std::bad_alloc();
}

HttpObjects::~HttpObjects() = default;

std::string HttpObjects::url_of(const std::string& key) const { return access_.url + "/" + key; }

bool HttpObjects::has(const std::string& key, double within) {
  return Borrowed(*this)
      ->ask({.method = Method::Head, .url = url_of(key), .seconds = within})
      .found;
}

std::optional<std::string> HttpObjects::get(const std::string& key, const std::stop_token& stop) {
  auto answer = Borrowed(*this)->ask({.url = url_of(key), .stop = stop});
  if (!answer.found) return std::nullopt;
  return std::move(answer.body);
}

void HttpObjects::put(const std::string& key, const std::string& bytes) {
  if (!Borrowed(*this)->ask({.method = Method::Put, .url = url_of(key), .body = &bytes}).found)
    throw error::tier_unavailable("its folder or bucket is not there", limits::kTierRest.count());
}

std::optional<std::string> HttpObjects::start_of(const std::string& key, std::size_t bytes) {
  auto answer = Borrowed(*this)->ask({.url = url_of(key), .most = bytes});
  if (!answer.found) return std::nullopt;
  return std::move(answer.body);
}

void HttpObjects::remove(const std::string& key) {
  Borrowed(*this)->ask({.method = Method::Delete, .url = url_of(key)});
}

void HttpObjects::list(const std::string& prefix,
                       const std::function<void(const ObjectInfo&)>& visit) {
  if (access_.region.empty()) {
    list_folder(prefix, visit);
  } else {
    list_bucket(prefix, visit);
  }
}

void HttpObjects::list_folder(const std::string& folder,
                              const std::function<void(const ObjectInfo&)>& visit) {
  const auto answer = Borrowed(*this)->ask({.url = url_of(folder)});
  if (!answer.found) return;
  const auto listed = folder_in(answer.body);
  if (!listed)
    throw error::tier_unavailable("it does not list its folders as JSON (nginx: autoindex_format)",
                                  limits::kTierRest.count());
  for (ObjectInfo file : listed->files) {
    file.key = folder + file.key;
    visit(file);
  }
  for (const std::string& name : listed->folders) list_folder(folder + name + "/", visit);
}

void HttpObjects::list_bucket(const std::string& prefix,
                              const std::function<void(const ObjectInfo&)>& visit) {
  const BucketAddress bucket = bucket_address(access_.url);
  std::string next;
  do {
    // Parameters in the order of their names, as the signature needs them.
    std::string query = next.empty() ? "" : "continuation-token=" + query_escaped(next) + "&";
    query += "list-type=2&prefix=" + query_escaped(bucket.prefix + prefix);
    const auto answer = Borrowed(*this)->ask({.url = bucket.url + "?" + query});
    const auto page = answer.found ? bucket_in(answer.body) : std::nullopt;
    if (!page)
      throw error::tier_unavailable("it does not list its objects", limits::kTierRest.count());
    for (ObjectInfo object : page->objects) {
      object.key = object.key.substr(bucket.prefix.size());
      visit(object);
    }
    next = page->next;
  } while (!next.empty());
}

}  // namespace remeshd
