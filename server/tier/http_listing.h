#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/tier/object_store.h"

namespace remeshd {

/// Readers of the lists of objects that servers send.

/// A folder as nginx lists it with `autoindex_format json`.
struct ListedFolder {
  std::vector<ObjectInfo> files;     ///< `key` is the file's name
  std::vector<std::string> folders;  ///< names
};
/// Nothing where the text is no such list.
std::optional<ListedFolder> folder_in(const std::string& json);

/// A page of a bucket, as S3's ListObjectsV2 answers it.
struct ListedBucket {
  std::vector<ObjectInfo> objects;
  std::string next;  ///< token of the next page; empty for the last
};
std::optional<ListedBucket> bucket_in(const std::string& xml);

/// The URL of a tier, to which keys are appended, cut into the URL of its bucket and the prefix of
/// keys in that: of `https://HOST/BUCKET/PREFIX` or `https://BUCKET.s3.REGION.HOST/PREFIX`.
struct BucketAddress {
  std::string url;     ///< without a slash at the end
  std::string prefix;  ///< empty, or with a slash at the end
};
BucketAddress bucket_address(const std::string& url);

/// A text percent-encoded for the query of a URL.
std::string query_escaped(const std::string& text);

}  // namespace remeshd
