#include "server/tier/http_listing.h"

#include <curl/curl.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

namespace remeshd {
namespace {

using nlohmann::json;

constexpr std::int64_t kNanosecondsOfASecond = 1'000'000'000;

/// ns since 1970 of a time such as `Wed, 15 Nov 2023 08:41:34 GMT` or `2023-11-15T08:41:34.000Z`.
/// Of the latter curl reads the date only without dashes. Nothing where it is no time.
std::optional<std::int64_t> nanoseconds_at(std::string text) {
  constexpr std::size_t kDate = 10, kTime = 8;
  if (text.size() > kDate + kTime && text[kDate] == 'T') {
    std::string date = text.substr(0, kDate);
    std::erase(date, '-');
    text = date + " " + text.substr(kDate + 1, kTime) + " GMT";
  }
  const std::int64_t seconds = curl_getdate(text.c_str(), nullptr);
  if (seconds < 0) return std::nullopt;
  return kNanosecondsOfASecond * seconds;
}

}  // namespace

std::optional<ListedFolder> folder_in(const std::string& text) {
  const json list = json::parse(text, nullptr, false);
  if (!list.is_array()) return std::nullopt;
  ListedFolder folder;
  try {
    for (const json& entry : list) {
      if (entry.at("type") == "directory") {
        folder.folders.push_back(entry.at("name"));
      } else {
        const auto written = nanoseconds_at(entry.at("mtime"));
        if (!written) return std::nullopt;
        folder.files.push_back(
            {.key = entry.at("name"), .bytes = entry.at("size"), .written_ns = *written});
      }
    }
  } catch (const json::exception&) {
    return std::nullopt;
  }
  return folder;
}

std::optional<ListedBucket> bucket_in(const std::string& text) {
  pugi::xml_document document;
  if (!document.load_buffer(text.data(), text.size())) return std::nullopt;
  const pugi::xml_node list = document.child("ListBucketResult");
  if (!list) return std::nullopt;
  ListedBucket bucket;
  for (const pugi::xml_node object : list.children("Contents")) {
    const auto written = nanoseconds_at(object.child_value("LastModified"));
    if (!written) return std::nullopt;
    bucket.objects.push_back({.key = object.child_value("Key"),
                              .bytes = object.child("Size").text().as_ullong(),
                              .written_ns = *written});
  }
  if (list.child("IsTruncated").text().as_bool())
    bucket.next = list.child_value("NextContinuationToken");
  return bucket;
}

BucketAddress bucket_address(const std::string& url) {
  const std::size_t host = url.find("://") + 3;
  const std::size_t path = std::min(url.find('/', host), url.size());
  const bool is_in_host = url.substr(host, path - host).find(".s3.") != std::string::npos;
  const std::size_t end =
      is_in_host ? path : std::min(url.find('/', std::min(path + 1, url.size())), url.size());
  const std::string rest = end < url.size() ? url.substr(end + 1) : "";
  return {.url = url.substr(0, end), .prefix = rest.empty() ? "" : rest + "/"};
}

std::string query_escaped(const std::string& text) {
  char* const escaped = curl_easy_escape(nullptr, text.data(), static_cast<int>(text.size()));
  std::string out = escaped == nullptr ? "" : escaped;
  curl_free(escaped);
  return out;
}

}  // namespace remeshd
